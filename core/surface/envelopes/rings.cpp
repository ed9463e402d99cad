#include "core/surface/envelopes/rings.h"

#include <cassert>
#include <numbers>

namespace espalier {

SurfaceMesh meshOfRings(const Eigen::Vector3d& bottom, const std::vector<Ring>& rings,
                        const Eigen::Vector3d& top) {
  assert(!rings.empty() && rings.front().size() >= 3);
  const auto around = static_cast<int>(rings.front().size());
  const auto levels = static_cast<int>(rings.size());
  SurfaceMesh mesh;
  mesh.corners.push_back(bottom);
  for (const Ring& ring : rings)
    mesh.corners.insert(mesh.corners.end(), ring.begin(), ring.end());
  mesh.corners.push_back(top);
  const auto corner = [&](int level, int i) { return 1 + level * around + i % around; };
  const int last = levels * around + 1;
  for (int i = 0; i < around; ++i) {
    mesh.triangles.push_back({0, corner(0, i + 1), corner(0, i)});
    for (int level = 0; level + 1 < levels; ++level) {
      mesh.triangles.push_back({corner(level, i), corner(level, i + 1), corner(level + 1, i + 1)});
      mesh.triangles.push_back({corner(level, i), corner(level + 1, i + 1), corner(level + 1, i)});
    }
    mesh.triangles.push_back({corner(levels - 1, i), corner(levels - 1, i + 1), last});
  }
  return mesh;
}

SurfaceMesh meshOfTurned(const std::vector<Eigen::Vector2d>& profile,
                         const Eigen::Vector2d& center) {
  std::vector<Ring> rings;
  for (const Eigen::Vector2d& at : profile) {
    if (at.x() <= 0) continue;
    Ring ring;
    for (int i = 0; i < ringCorners; ++i) {
      const double angle = 2 * std::numbers::pi * i / ringCorners;
      ring.emplace_back(center.x() + at.x() * std::cos(angle),
                        center.y() + at.x() * std::sin(angle), at.y());
    }
    rings.push_back(std::move(ring));
  }
  const auto end = [&](double z) { return Eigen::Vector3d(center.x(), center.y(), z); };
  return meshOfRings(end(profile.front().y()), rings, end(profile.back().y()));
}

} // namespace espalier
