#pragma once

#include "core/base/error.h"
#include "core/base/shown.h"

#include <string>
#include <vector>

namespace espalier {

/// A sentence with what is put into it, which the window can translate
/// (ui/document/shown_message.h): text that is joined of pieces could not be. One and many have a
/// sentence each.
struct ShownMessage {
  std::string sentence;                 // marked by Shown::tr(), with %1 ... %9 for the values
  std::vector<std::string> values = {}; // numbers, names and texts of the user

  bool operator==(const ShownMessage&) const = default;
};

/// The whole sentence in English.
[[nodiscard]] std::string inEnglish(const ShownMessage& message);

[[nodiscard]] std::vector<std::string> eachInEnglish(const std::vector<ShownMessage>& messages);

/// An Error that the window shows in its language.
class ShownError : public Error {
public:
  explicit ShownError(ShownMessage message);

  [[nodiscard]] const ShownMessage& message() const { return message_; }

private:
  ShownMessage message_;
};

} // namespace espalier
