#pragma once

#include "ui/view/drawn_looks.h"
#include "ui/view/gl_objects.h"
#include "ui/view/scene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// A scene in the memory of the graphics card: once, however many views show it. Their contexts
/// must share what is held in them.
class SceneBuffers {
public:
  struct Points {
    GlBuffer positions;
    GlBuffer scanned;       // where they come from; empty: as the points of the cloud
    GlBuffer colors;        // empty: all of one color
    GlBuffer displacements; // pairs of places, if these are shown
    std::uint64_t revision = 0;
    std::uint64_t colorRevision = 0;
    std::uint64_t displacedRevision = 0; // 0: not uploaded
  };

  struct Glyphs {
    GlBuffer nodes;
    GlBuffer edges;
  };

  // What changed since the last upload, no more; a context must be current.
  void uploadPoints(const Scene& scene);
  void uploadSkeleton(Scene& scene);  // takes from the scene what changed
  void uploadReference(Scene& scene); // likewise
  void uploadOther(Scene& scene, Side side);

  [[nodiscard]] const Points& cloud() const { return cloud_; }
  /// @param other a state on a side of the divider; none: of the plant itself
  [[nodiscard]] const Points& contracted(std::optional<Side> other = {}) const {
    return other ? others_[static_cast<std::size_t>(*other)].contracted : contracted_;
  }
  [[nodiscard]] const Points& moved() const { return moved_; } // of the other scan
  [[nodiscard]] const Glyphs& skeleton() const { return skeleton_; }
  [[nodiscard]] const Glyphs& reference() const { return reference_; }
  [[nodiscard]] const Glyphs& skeleton(Side side) const {
    return others_[static_cast<std::size_t>(side)].skeleton;
  }
  /// Which corners make the triangles of glyphs: of `count` at least.
  [[nodiscard]] const GlBuffer& quads(std::size_t count);
  [[nodiscard]] std::size_t bytes(); // in all

  /// Counts who draws from them. The last to leave frees them; and who leaves without its context,
  /// in which they went. What another draws later is uploaded anew.
  void join() { ++users_; }
  void leave(bool isCurrent);

private:
  struct Other {
    Points contracted;
    Glyphs skeleton;
  };
  [[nodiscard]] std::vector<GlBuffer*> all();

  Points cloud_;
  Points contracted_;
  Points moved_;
  Glyphs skeleton_;
  Glyphs reference_;
  std::array<Other, 2> others_;
  DrawnLooks looks_{PointPlace::scanned}; // as they were uploaded
  DrawnLooks contractedLooks_{PointPlace::contracted};
  GlBuffer quads_;
  int users_ = 0;
};

} // namespace espalier
