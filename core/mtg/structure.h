#pragma once

#include "core/mtg/mtg.h"
#include "core/skeleton/skeleton.h"

#include <memory>
#include <string>

namespace espalier {

/// The MTG that a skeleton was read from, and its text.
struct MtgFrame {
  Mtg mtg;
  std::string text; // bytes of the file, or as it is written if that was no text; reads as `mtg`;
                    // empty: there is none that holds all of it
};

/// A skeleton with the MTG that it is a view of.
///
/// The frame never changes: what was edited since is what separates the skeleton from
/// skeletonOf(frame->mtg), whose nodes keep their ids. So undo needs no frame of its own, and
/// withEdits(frame->mtg, skeleton) is what to write at any time.
struct Structure {
  Skeleton skeleton;
  std::shared_ptr<const MtgFrame> frame = nullptr; // null: the skeleton is all there is
};

} // namespace espalier
