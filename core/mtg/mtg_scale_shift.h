#pragma once

#include "core/mtg/mtg.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/skeleton/skeleton.h"

#include <map>

namespace espalier {

/// Where the scales of an MTG are in a skeleton that got scales in between by hand.
///
/// By how much the scale of the nodes rose is read off their own entities. Which coarser scales
/// rose with it is shown by the classes: the order of scales stays, and most entities keep their
/// class. Where nothing shows it, a scale stays.
class ScaleShift {
public:
  /// @param nodeScale  of the vertices of `base` that are nodes
  /// Time O(size of both + scales^3).
  ScaleShift(const Mtg& base, int nodeScale, const Skeleton& edited);

  [[nodiscard]] bool isNone() const { return shifts_.empty(); }
  [[nodiscard]] int operator()(int scale) const; // of `base` to that of `edited`

private:
  std::map<int, int> shifts_; // by the scale of `base` from which on it holds
};

/// The same plant with its scales moved.
[[nodiscard]] Mtg withScales(Mtg mtg, const ScaleShift& shift);
[[nodiscard]] MtgView withScales(MtgView view, const ScaleShift& shift);

} // namespace espalier
