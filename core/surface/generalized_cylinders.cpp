#include "core/surface/generalized_cylinders.h"

#include "core/base/shown_message.h"
#include "core/skeleton/axes.h"
#include "core/surface/axis_sweep.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

namespace espalier {
namespace {

/// Fills the radii of an axis that are not known (0) from those that are, along its length.
/// @return whether any is known
bool fillAlong(const Skeleton& skeleton, const Axis& axis, std::vector<double>& radii) {
  std::vector<double> places(axis.size(), 0.0); // along the axis [L]
  for (std::size_t i = 1; i < axis.size(); ++i)
    places[i] =
        places[i - 1] + (skeleton[axis[i]].position - skeleton[axis[i - 1]].position).norm();
  std::optional<std::size_t> known;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const double radius = radii[indexOf(axis[i])];
    if (radius <= 0) continue;
    const double before = known ? radii[indexOf(axis[*known])] : radius;
    const double from = known ? places[*known] : places[i];
    for (std::size_t gap = known ? *known + 1 : 0; gap < i; ++gap) {
      const double t = places[i] > from ? (places[gap] - from) / (places[i] - from) : 0;
      radii[indexOf(axis[gap])] = known ? (1 - t) * before + t * radius : radius;
    }
    known = i;
  }
  if (!known) return false;
  for (std::size_t i = *known + 1; i < axis.size(); ++i)
    radii[indexOf(axis[i])] = radii[indexOf(axis[*known])];
  return true;
}

/// Radii of all nodes by id; those that are not known are filled in.
std::vector<double> filledRadii(const Skeleton& skeleton, const std::vector<Axis>& all) {
  std::vector<double> radii(skeleton.idEnd(), 0.0);
  double sum = 0;
  int known = 0;
  for (const NodeId id : skeleton.ids()) {
    radii[indexOf(id)] = skeleton[id].radius;
    sum += skeleton[id].radius;
    known += skeleton[id].radius > 0 ? 1 : 0;
  }
  if (known == 0) throw ShownError({Shown::tr("no node has a radius: estimate radii first")});
  for (const Axis& axis : all) { // each after the one that bears it
    if (fillAlong(skeleton, axis, radii)) continue;
    const auto bearer = skeleton[axis.front()].parent;
    for (const NodeId id : axis)
      radii[indexOf(id)] = bearer ? radii[indexOf(*bearer)] : sum / known;
  }
  return radii;
}

/// Adds the piece of one axis to a mesh.
class Sweep {
public:
  Sweep(SurfaceMesh& mesh, int sides) : mesh_(mesh), sides_(sides) {
    const double corner = 2 * std::numbers::pi / sides;
    fullness_ = std::sqrt(corner / std::sin(corner)); // polygon and circle have one area
  }

  void add(const std::vector<Section>& sections) {
    Ring before = ringOf(sections.front());
    cap(before, sections.front().center, false);
    for (std::size_t i = 1; i < sections.size(); ++i) {
      const Ring ring = ringOf(sections[i]);
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::size_t next = (k + 1) % ring.size();
        mesh_.triangles.push_back({before[k], before[next], ring[next]});
        mesh_.triangles.push_back({before[k], ring[next], ring[k]});
      }
      before = ring;
    }
    cap(before, sections.back().center, true);
  }

private:
  using Ring = std::vector<int>; // corners, counterclockwise as seen from the apex

  int cornerAt(const Eigen::Vector3d& place) {
    mesh_.corners.push_back(place);
    return static_cast<int>(mesh_.corners.size()) - 1;
  }

  Ring ringOf(const Section& section) {
    const Eigen::Vector3d aside = section.normal.cross(section.forward);
    Ring ring;
    for (int k = 0; k < sides_; ++k) {
      const double angle = 2 * std::numbers::pi * k / sides_;
      ring.push_back(cornerAt(section.center +
                              section.radius * fullness_ *
                                  (std::cos(angle) * section.forward + std::sin(angle) * aside)));
    }
    return ring;
  }

  void cap(const Ring& ring, const Eigen::Vector3d& center, bool isApex) {
    const int middle = cornerAt(center);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const std::size_t next = (k + 1) % ring.size();
      if (isApex)
        mesh_.triangles.push_back({middle, ring[k], ring[next]});
      else
        mesh_.triangles.push_back({middle, ring[next], ring[k]});
    }
  }

  SurfaceMesh& mesh_;
  int sides_;
  double fullness_ = 1;
};

} // namespace

SurfaceMesh surfaceByGeneralizedCylinders(const Skeleton& skeleton, const SurfaceOptions& options,
                                          const Progress& progress) {
  assert(options.sides >= 3 && options.turn > 0);
  const std::vector<Axis> all = axes(skeleton);
  const std::vector<double> radii = filledRadii(skeleton, all);
  SurfaceMesh mesh;
  Sweep sweep(mesh, options.sides);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<Section> sections = sectionsOf(skeleton, all[i], radii, options.turn);
    if (!sections.empty()) sweep.add(sections);
    progress.update(static_cast<double>(i + 1) / static_cast<double>(all.size()));
  }
  return mesh;
}

} // namespace espalier
