#pragma once

#include "ui/view/gl_objects.h"
#include "ui/view/scene.h"

#include <cstdint>

namespace espalier {

/// A scene in the memory of the graphics card: once, however many views show it. Their contexts
/// must share what is held in them.
class SceneBuffers {
public:
  struct Points {
    GlBuffer positions;
    GlBuffer colors; // empty: all of one color
    std::uint64_t revision = 0;
    std::uint64_t colorRevision = 0;
  };

  struct Glyphs {
    GlBuffer nodes;
    GlBuffer edges;
  };

  // What changed since the last upload, no more; a context must be current.
  void uploadPoints(const Scene& scene);
  void uploadSkeleton(Scene& scene);  // takes from the scene what changed
  void uploadReference(Scene& scene); // likewise

  [[nodiscard]] const Points& cloud() const { return cloud_; }
  [[nodiscard]] const Points& contracted() const { return contracted_; }
  [[nodiscard]] const Glyphs& skeleton() const { return skeleton_; }
  [[nodiscard]] const Glyphs& reference() const { return reference_; }
  /// Which corners make the triangles of glyphs: of `count` at least.
  [[nodiscard]] const GlBuffer& quads(std::size_t count);
  [[nodiscard]] std::size_t bytes() const; // in all

  /// Counts who draws from them. The last to leave frees them, if its context still is current;
  /// what another draws later is uploaded anew.
  void join() { ++users_; }
  void leave(bool isCurrent);

private:
  Points cloud_;
  Points contracted_;
  Glyphs skeleton_;
  Glyphs reference_;
  GlBuffer quads_;
  int users_ = 0;
};

} // namespace espalier
