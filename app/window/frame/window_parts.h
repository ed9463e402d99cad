#pragma once

#include "app/window/frame/window_part.h"

#include <QtGlobal>

#include <memory>
#include <utility>
#include <vector>

namespace espalier {

/// The parts of the window, in the order in which they were made. The last one goes first.
class WindowParts {
public:
  WindowParts() = default;
  WindowParts(const WindowParts&) = delete;
  WindowParts& operator=(const WindowParts&) = delete;
  ~WindowParts() {
    for (const auto& part : parts_)
      part->endWork();
    while (!parts_.empty())
      parts_.pop_back();
  }

  template <class Made, class... Arguments> Made& make(Arguments&&... arguments) {
    auto part = std::make_unique<Made>(std::forward<Arguments>(arguments)...);
    Made& made = *part;
    parts_.push_back(std::move(part));
    return made;
  }

  /// pre: it was made
  template <class Wanted> [[nodiscard]] Wanted& get() const {
    Wanted* found = nullptr;
    for (const auto& part : parts_)
      if (found == nullptr) found = dynamic_cast<Wanted*>(part.get());
    Q_ASSERT(found != nullptr);
    return *found;
  }

  [[nodiscard]] auto begin() const { return parts_.begin(); }
  [[nodiscard]] auto end() const { return parts_.end(); }

private:
  std::vector<std::unique_ptr<WindowPart>> parts_;
};

} // namespace espalier
