#include "ui/view/close_look.h"

#include "ui/view/scene.h"
#include "ui/view/visibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace espalier {
namespace {

constexpr int yaws = 12;
constexpr std::array pitches = {0.25, 0.9, -0.4}; // [rad], beside that of now
constexpr double steepest = 1.2;                  // [rad]: from above the plant is not recognized
constexpr double edge = 12;                       // [logical pixels] of the screen are too far out
constexpr std::size_t mostMeant = 200;            // nodes or places; of more some are looked at

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
      : scene_(scene), now_(now), size_(std::max(1.0, size.width()), std::max(1.0, size.height())),
        margin_(sight.margin), isOfOther_(sight.isOfOther), places_(some(sight.places, mostMeant)) {
    for (const NodeId id : some(sight.nodes, mostMeant))
      meant_.push_back(indexOf(id));
    outline_ = places_;
    for (const std::size_t slot : meant_) {
      outline_.push_back(scene.skeleton.position(slot));
      outline_.push_back(parentEnd(scene.skeleton, slot));
    }
    if (!isOfOther_) findAround();
  }

  [[nodiscard]] Camera best() const {
    std::vector<Candidate> candidates = directions();
    std::ranges::stable_sort(candidates, std::greater<>(), &Candidate::worth);
    Candidate best = candidates.front();
    double most = -1;
    for (const Candidate& candidate : candidates) {
      const Seen seen = look(candidate.camera);
      constexpr double nearlyAll = 0.9;
      if (seen.ofMeant >= 1 && seen.ofAround >= nearlyAll) return candidate.camera;
      const double worth = 4 * seen.ofMeant + seen.ofAround + candidate.worth;
      if (worth <= most) continue;
      most = worth;
      best = candidate;
    }
    return best.camera;
  }

private:
  struct Candidate {
    Camera camera;
    double worth; // before anything is known of what is hidden, in [0, 1]
  };
  struct Seen { // shares
    double ofMeant;
    double ofAround;
  };

  /// The nodes in the ball that is shown.
  void findAround() {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& place : outline_)
      box.extend(place);
    const double reach = box.diagonal().norm() / 2 + margin_;
    std::vector<std::size_t> near;
    for (std::size_t slot = 0; slot < scene_.skeleton.nodes().size(); ++slot)
      if (scene_.skeleton.nodes()[slot].shape != NodeShape::none &&
          (scene_.skeleton.position(slot) - box.center()).norm() <= reach)
        near.push_back(slot);
    around_ = some(near, mostMeant);
  }

  [[nodiscard]] std::vector<Candidate> directions() const {
    std::vector<Candidate> candidates;
    std::vector<double> heights(pitches.begin(), pitches.end());
    heights.insert(heights.begin(), std::clamp(now_.pitch, -steepest, steepest));
    for (const double pitch : heights)
      for (int turn = 0; turn < yaws; ++turn) {
        Camera camera = now_;
        camera.pitch = pitch;
        camera.yaw =
            std::remainder(now_.yaw + 2 * std::numbers::pi * turn / yaws, 2 * std::numbers::pi);
        aim(camera);
        const double kept = (1 + camera.forward().dot(now_.forward())) / 2;
        candidates.push_back({camera, 0.6 * lengthSeen(camera) + 0.4 * kept});
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
    camera.frame(places, size_.x() / size_.y());
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

  [[nodiscard]] Seen look(const Camera& camera) const {
    const ScreenMap screen(camera, size_);
    const QRectF covering = isOfOther_ ? QRectF() : QRectF(0, 0, size_.x(), size_.y());
    const Visibility visibility(scene_, screen, covering);
    const auto isOn = [&](const std::optional<ScreenMap::Place>& at) {
      return at && at->pixel.x() > edge && at->pixel.y() > edge &&
             at->pixel.x() < size_.x() - edge && at->pixel.y() < size_.y() - edge;
    };
    const auto isNodeSeen = [&](std::size_t slot) {
      const auto at = screen.project(scene_.skeleton.position(slot));
      return isOn(at) && !visibility.hidesNode(slot, *at);
    };
    const auto isPlaceSeen = [&](const Eigen::Vector3d& place) {
      const auto at = screen.project(place);
      return isOn(at) && (isOfOther_ || !visibility.hidesPoint(*at));
    };
    const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 1; };
    const auto meant = double(std::ranges::count_if(meant_, isNodeSeen) +
                              std::ranges::count_if(places_, isPlaceSeen));
    return {share(meant, double(meant_.size() + places_.size())),
            share(double(std::ranges::count_if(around_, isNodeSeen)), double(around_.size()))};
  }

  const Scene& scene_;
  const Camera& now_;
  Eigen::Vector2d size_; // [logical pixels]
  double margin_;        // [L]
  bool isOfOther_;
  std::vector<std::size_t> meant_;
  std::vector<Eigen::Vector3d> places_;  // [L]
  std::vector<Eigen::Vector3d> outline_; // of all that is meant [L]
  std::vector<std::size_t> around_;
};

} // namespace

Camera cameraToSee(const Scene& scene, const Camera& now, const Sight& sight, const QSizeF& size) {
  return CloseLook(scene, now, sight, size).best();
}

} // namespace espalier
