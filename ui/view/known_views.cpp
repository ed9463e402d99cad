#include "ui/view/known_views.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr std::size_t mostKnown = 500; // as many as there are places that one still remembers

bool areAlike(const KnownViews::Situation& a, const KnownViews::Situation& b) {
  return a.projection == b.projection && a.up == b.up && std::abs(a.aspect - b.aspect) < 1e-3 &&
         a.place.min() == b.place.min() && a.place.max() == b.place.max();
}

} // namespace

std::optional<Camera> KnownViews::find(const Sight& sight, const Situation& now) const {
  const auto found = std::ranges::find_if(known_, [&](const Known& known) {
    return areAlike(known.situation, now) && known.sight == sight;
  });
  return found != known_.end() ? std::optional(found->camera) : std::nullopt;
}

void KnownViews::keep(const Sight& sight, const Situation& now, const Camera& camera) {
  if (known_.size() == mostKnown) known_.pop_front();
  known_.push_back({sight, now, camera});
}

} // namespace espalier
