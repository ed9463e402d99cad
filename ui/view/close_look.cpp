#include "ui/view/close_look.h"

#include "core/cloud/sight_grid.h"
#include "ui/view/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace espalier {
namespace {

constexpr int yaws = 16;
constexpr std::array pitches = {0.25, 0.6, 0.9, -0.1, -0.4}; // [rad], beside that of now
constexpr double steepest = 1.2;        // [rad]: from above the plant is not recognized
constexpr std::size_t mostMeant = 200;  // nodes or places; of more some are looked at
constexpr std::size_t mostTargets = 40; // to which lines of sight go
constexpr double cellsAcross = 48;      // from what is meant to the eye

/// An even choice of at most `most`.
template <class T> std::vector<T> some(const std::vector<T>& all, std::size_t most) {
  std::vector<T> chosen;
  const std::size_t step = 1 + all.size() / most;
  for (std::size_t i = 0; i < all.size(); i += step)
    chosen.push_back(all[i]);
  return chosen;
}

Eigen::Vector3d parentEnd(const SkeletonGlyphs& glyphs, std::size_t slot) {
  const EdgeGlyph& glyph = glyphs.edges()[slot];
  if (glyph.shape == EdgeShape::none) return glyphs.position(slot);
  return glyphs.origin() + Eigen::Vector3f(glyph.parent.data()).cast<double>();
}

class CloseLook {
public:
  CloseLook(const Scene& scene, const Camera& now, const Sight& sight, const QSizeF& size)
      : scene_(scene), now_(now),
        aspect_(std::max(1.0, size.width()) / std::max(1.0, size.height())), margin_(sight.margin),
        isOfOther_(sight.isOfOther), places_(some(sight.places, mostMeant)), apart_(sight.apart) {
    for (const NodeId id : some(sight.nodes, mostMeant))
      meant_.push_back(indexOf(id));
    outline_ = places_;
    for (const std::size_t slot : meant_) {
      outline_.push_back(scene.skeleton.position(slot));
      outline_.push_back(parentEnd(scene.skeleton, slot));
    }
    for (const Eigen::Vector3d& place : outline_)
      box_.extend(place);
    if (isOfOther_) return; // nothing stands before it
    addMeant();
    addAround();
    fillGrid();
  }

  [[nodiscard]] Camera best() const {
    Camera best = now_;
    double most = -1;
    for (const Camera& camera : directions()) {
      const double kept = (1 + camera.forward().dot(now_.forward())) / 2;
      const double worth = 4 * seen(targets_, camera) + 0.5 * seen(around_, camera) +
                           0.6 * lengthSeen(camera) + 2 * separation(camera) + 0.4 * kept;
      if (worth <= most + 1e-9) continue;
      most = worth;
      best = camera;
    }
    return best;
  }

private:
  struct Target {
    Eigen::Vector3d place; // [L]
    double reach;          // of its own surface toward the eye [L]
  };

  void addMeant() {
    const double noise = 3 * scene_.points.spacing;
    const auto edges = static_cast<double>(std::max<std::size_t>(meant_.size(), 1));
    const int steps = std::clamp(static_cast<int>(mostTargets / edges), 1, 8);
    for (const std::size_t slot : some(meant_, mostTargets)) {
      const Eigen::Vector3d from = parentEnd(scene_.skeleton, slot);
      const Eigen::Vector3d to = scene_.skeleton.position(slot);
      const double radius = scene_.skeleton.nodes()[slot].radius;
      for (int step = 1; step <= steps; ++step)
        targets_.push_back({from + (to - from) * step / steps, 1.5 * radius + noise});
    }
    for (const Eigen::Vector3d& place : some(places_, mostTargets))
      targets_.push_back({place, noise});
  }

  /// The nodes in the ball that is shown.
  void addAround() {
    const double reach = box_.diagonal().norm() / 2 + margin_;
    std::vector<Target> near;
    for (std::size_t slot = 0; slot < scene_.skeleton.nodes().size(); ++slot) {
      const NodeGlyph& node = scene_.skeleton.nodes()[slot];
      if (node.shape != NodeShape::none &&
          (scene_.skeleton.position(slot) - box_.center()).norm() <= reach)
        near.push_back({scene_.skeleton.position(slot),
                        1.5 * double(node.radius) + 3 * scene_.points.spacing});
    }
    around_ = some(near, mostTargets);
  }

  /// What may stand between it and the eye.
  void fillGrid() {
    Camera camera = now_;
    aim(camera);
    const double far = camera.distance + box_.diagonal().norm() / 2;
    Eigen::AlignedBox3d reached(box_.center() - Eigen::Vector3d::Constant(far),
                                box_.center() + Eigen::Vector3d::Constant(far));
    if (!scene_.bounds().isEmpty()) reached = reached.intersection(scene_.bounds());
    if (reached.isEmpty()) return;
    const double leastCell = 2 * scene_.points.spacing; // or a surface has holes
    grid_.emplace(reached, std::max({far / cellsAcross, leastCell, 1e-12}));
    if (scene_.points.visible) addPoints(reached);
    if (scene_.skeletonVisible && scene_.showRadii) addFrusta();
  }

  void addPoints(const Eigen::AlignedBox3d& reached) {
    const PointLayer& points = scene_.points;
    const Eigen::Vector3d origin = scene_.origin();
    const Eigen::AlignedBox3f here((reached.min() - origin).cast<float>(),
                                   (reached.max() - origin).cast<float>());
    const double width = std::max(points.spacing, grid_->cell() / 8); // no point is a mere dot
    points.boxes.forEachRun([&](const Eigen::AlignedBox3f& box) { return box.intersects(here); },
                            [&](Eigen::Index begin, Eigen::Index end) {
                              for (Eigen::Index i = begin; i < end; ++i)
                                if (scene_.isPointShown(i))
                                  grid_->add(points.positions->col(i).cast<double>() + origin,
                                             width);
                            });
  }

  void addFrusta() {
    for (std::size_t slot = 0; slot < scene_.skeleton.edges().size(); ++slot) {
      const EdgeGlyph& edge = scene_.skeleton.edges()[slot];
      if (edge.shape == EdgeShape::none || std::ranges::find(meant_, slot) != meant_.end())
        continue;
      const Eigen::Vector3d from = parentEnd(scene_.skeleton, slot);
      const Eigen::Vector3d to = scene_.skeleton.position(slot);
      const int steps = 1 + static_cast<int>(std::min((to - from).norm() / grid_->cell(), 500.0));
      const double length = (to - from).norm() / steps;
      const double thick = double(edge.parentRadius) + double(edge.childRadius);
      for (int step = 0; step < steps; ++step)
        grid_->add(from + (to - from) * (step + 0.5) / steps, std::sqrt(length * thick));
    }
  }

  [[nodiscard]] std::vector<Camera> directions() const {
    std::vector<Camera> candidates;
    std::vector<double> heights(pitches.begin(), pitches.end());
    heights.insert(heights.begin(), std::clamp(now_.pitch, -steepest, steepest));
    for (const double pitch : heights)
      for (int turn = 0; turn < yaws; ++turn) {
        Camera camera = now_;
        camera.pitch = pitch;
        camera.yaw =
            std::remainder(now_.yaw + 2 * std::numbers::pi * turn / yaws, 2 * std::numbers::pi);
        aim(camera);
        candidates.push_back(camera);
      }
    return candidates;
  }

  void aim(Camera& camera) const {
    std::vector<Eigen::Vector3d> places;
    for (const Eigen::Vector3d& place : outline_)
      for (const double offset : {-margin_, margin_}) {
        places.emplace_back(place + offset * camera.right());
        places.emplace_back(place + offset * camera.up());
      }
    camera.frame(places, aspect_);
  }

  /// Of the edges, as a share of their length.
  [[nodiscard]] double lengthSeen(const Camera& camera) const {
    double whole = 0;
    double seen = 0;
    for (const std::size_t slot : meant_) {
      const Eigen::Vector3d along =
          scene_.skeleton.position(slot) - parentEnd(scene_.skeleton, slot);
      whole += along.norm();
      seen += along.cross(camera.forward()).norm();
    }
    return whole > 0 ? seen / whole : 1;
  }

  /// How far apart the two lines are on the screen that are least so, as a share of how far apart
  /// they are: of their middles, and their ends.
  [[nodiscard]] double separation(const Camera& camera) const {
    double least = 1;
    for (std::size_t a = 0; a < apart_.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        double whole = 0;
        double seen = 0;
        for (const double share : {0.0, 0.5, 1.0}) {
          const auto placeOn = [&](const std::vector<Eigen::Vector3d>& line) {
            const double at = share * static_cast<double>(line.size() - 1);
            return line[static_cast<std::size_t>(std::lround(at))];
          };
          if (apart_[a].empty() || apart_[b].empty()) continue;
          const Eigen::Vector3d span = placeOn(apart_[a]) - placeOn(apart_[b]);
          whole += span.norm();
          seen += span.cross(camera.forward()).norm();
        }
        if (whole > 0) least = std::min(least, seen / whole);
      }
    return least;
  }

  /// The mean share of them that nothing hides.
  [[nodiscard]] double seen(const std::vector<Target>& targets, const Camera& camera) const {
    if (!grid_ || targets.empty()) return 1;
    const double far = 1e3 * (grid_->cell() * cellsAcross); // parallel: from beyond the plant
    double sum = 0;
    for (const Target& target : targets) {
      const bool isParallel = camera.projection == Projection::parallel;
      const Eigen::Vector3d eye =
          isParallel ? (target.place - far * camera.forward()).eval() : camera.eye();
      sum += grid_->seen(target.place, eye, target.reach + 1.5 * grid_->cell());
    }
    return sum / static_cast<double>(targets.size());
  }

  const Scene& scene_;
  const Camera& now_;
  double aspect_; // of the screen
  double margin_; // [L]
  bool isOfOther_;
  std::vector<std::size_t> meant_;
  std::vector<Eigen::Vector3d> places_; // [L]
  std::vector<std::vector<Eigen::Vector3d>> apart_;
  std::vector<Eigen::Vector3d> outline_; // of all that is meant [L]
  Eigen::AlignedBox3d box_;              // about that
  std::vector<Target> targets_;          // on what is meant
  std::vector<Target> around_;
  std::optional<SightGrid> grid_; // none: nothing hides anything
};

} // namespace

Camera cameraToSee(const Scene& scene, const Camera& now, const Sight& sight, const QSizeF& size) {
  return CloseLook(scene, now, sight, size).best();
}

} // namespace espalier
