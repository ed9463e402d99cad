#include "core/skeleton/beside_points.h"

#include "core/base/parallel.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/frustum.h"
#include "core/skeleton/length_along.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace espalier {
namespace {

/// A point as its edge sees it.
struct Aside {
  Eigen::Vector3d offset; // from the center line, across it [L]
  double radius;          // of the wood there [L]
};

/// By how much wood of a given radius is to be moved so that points lie on its surface.
class Fit {
public:
  Fit(std::vector<Aside> points, Eigen::Vector3d along, double width)
      : points_(std::move(points)), along_(std::move(along)), width_(width) {}

  /// Least squares, in which far points count less.
  [[nodiscard]] Eigen::Vector3d shift() const {
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    constexpr int steps = 12;
    for (int step = 0; step < steps; ++step) {
      Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      double weights = 0;
      for (const Aside& point : points_) {
        const Eigen::Vector3d from = point.offset - shift;
        const double length = from.norm();
        if (length == 0) continue;
        const Eigen::Vector3d outward = from / length;
        const double error = length - point.radius;
        const double weight = 1 / (1 + std::pow(error / width_, 2));
        matrix += weight * outward * outward.transpose();
        sum += weight * error * outward;
        weights += weight;
      }
      // Points on one side alone say nothing of the direction along their surface.
      matrix += weights * (0.05 * Eigen::Matrix3d::Identity() + along_ * along_.transpose());
      const Eigen::Vector3d change = matrix.ldlt().solve(sum);
      shift += change - change.dot(along_) * along_;
    }
    return shift;
  }

  /// The middle of points in one layer that is wider than the wood, as of a blade [L]. None: they
  /// lie about the wood, or on one side of it.
  [[nodiscard]] std::optional<Eigen::Vector3d> middleOfBlade() const {
    constexpr double thickest = 0.15; // of its width, as standard deviations
    // Radii, likewise: so little of the wood that it looks flat is narrower.
    constexpr double narrowest = 0.5;
    const auto count = static_cast<double>(points_.size());
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double radius = 0;
    for (const Aside& point : points_) {
      middle += (point.offset - point.offset.dot(along_) * along_) / count;
      radius += point.radius / count;
    }
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Aside& point : points_) {
      const Eigen::Vector3d off = point.offset - point.offset.dot(along_) * along_ - middle;
      spread += off * off.transpose() / count;
    }
    const Eigen::Vector3d variances =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread, Eigen::EigenvaluesOnly)
            .eigenvalues(); // ascending, the first along the wood
    const bool isLayer = variances[1] <= thickest * thickest * variances[2];
    const bool isWide = variances[2] >= std::pow(narrowest * radius, 2);
    return isLayer && isWide ? std::optional(middle) : std::nullopt;
  }

  /// The median distance of the points from the surface of wood that is moved [L].
  [[nodiscard]] double distance(const Eigen::Vector3d& shift) const {
    std::vector<double> errors;
    errors.reserve(points_.size());
    for (const Aside& point : points_)
      errors.push_back(std::abs((point.offset - shift).norm() - point.radius));
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::ranges::nth_element(errors, middle);
    return *middle;
  }

private:
  std::vector<Aside> points_;
  Eigen::Vector3d along_;
  double width_; // [L]: points this far from the surface count half
};

/// A part of an axis, by how far it has come along the line between its ends. What lies beside
/// points is no longer nearest to them: they are compared with what is as far along.
class Course {
public:
  Course(const Skeleton& skeleton, const std::vector<NodeId>& run, Eigen::Vector3d along)
      : along_(std::move(along)) {
    for (std::size_t i = 1; i < run.size(); ++i) {
      bodies_.push_back(*frustumOf(skeleton, run[i]));
      const double height = heightOf(bodies_.back().to);
      highest_.push_back(highest_.empty() ? height : std::max(height, highest_.back()));
    }
    for (auto body = bodies_.rbegin(); body != bodies_.rend(); ++body) {
      const double height = heightOf(body->from);
      lowest_.push_back(lowest_.empty() ? height : std::min(height, lowest_.back()));
    }
    std::ranges::reverse(lowest_);
  }

  /// How far along a place is [L].
  [[nodiscard]] double heightOf(const Eigen::Vector3d& place) const { return place.dot(along_); }

  /// Beside what is as far along. None: that is beyond the ends, or the axis leads back and comes
  /// as far more than once.
  [[nodiscard]] std::optional<Aside> asideOf(const Eigen::Vector3d& place) const {
    const double height = heightOf(place);
    const auto first = std::ranges::lower_bound(highest_, height) - highest_.begin();
    const auto last = std::ranges::lower_bound(lowest_, height) - lowest_.begin() - 1;
    if (first != last || first < 0 || first == std::ssize(bodies_)) return std::nullopt;
    const Frustum& body = bodies_[static_cast<std::size_t>(first)];
    const double from = heightOf(body.from);
    const double share = (height - from) / (heightOf(body.to) - from);
    return Aside{place - body.at(share), body.radiusAt(share)};
  }

private:
  std::vector<Frustum> bodies_;
  Eigen::Vector3d along_;
  std::vector<double> highest_; // that each body and those before lead to [L]
  std::vector<double> lowest_;  // that each body and those behind begin at [L]
};

/// The nodes of an axis up to `reach` [L] from one of them and the next ones, upward.
std::vector<NodeId> axisAround(const Skeleton& skeleton, NodeId id, double reach) {
  std::vector<NodeId> run = {id};
  double length = 0;
  for (auto at = previousOnAxis(skeleton, id); at && length < reach;
       at = previousOnAxis(skeleton, *at)) {
    length += edgeLength(skeleton, run.back());
    run.push_back(*at);
  }
  if (length < reach && skeleton[run.back()].parent) run.push_back(*skeleton[run.back()].parent);
  std::ranges::reverse(run);
  length = 0;
  for (auto at = nextOnAxis(skeleton, id); at && length < reach; at = nextOnAxis(skeleton, *at)) {
    run.push_back(*at);
    length += edgeLength(skeleton, *at);
  }
  return run;
}

/// The wood around a node, and the points about it; none: these are too few.
/// @param width     as Fit has it [L]
/// @param eachPoint calls its second argument with each point [L] that is nearest to the edge of
///                  its first
template <class EachPoint>
std::optional<Fit> fitAround(const Skeleton& skeleton, NodeId id, double spacing, double width,
                             const EachPoint& eachPoint) {
  const double radius = skeleton[id].radius;
  const double reach = std::max(4 * spacing, radius);
  const std::vector<NodeId> run =
      axisAround(skeleton, id, 3 * reach); // so far it may lead aside and back
  const Eigen::Vector3d along = skeleton[run.back()].position - skeleton[run.front()].position;
  if (along.isZero(0)) return std::nullopt;
  const Course course(skeleton, run, along.normalized());
  const double height = course.heightOf(skeleton[id].position);
  std::vector<Aside> points;
  const double farthest = 3 * std::max(radius, 4 * spacing);
  for (std::size_t i = 1; i < run.size(); ++i)
    eachPoint(run[i], [&](const Eigen::Vector3d& place) {
      if (std::abs(course.heightOf(place) - height) > reach) return;
      const std::optional<Aside> aside = course.asideOf(place);
      if (!aside || aside->offset.norm() > aside->radius + farthest) return; // other wood
      points.push_back(*aside);
    });
  constexpr std::size_t fewest = 6; // that say where the wood is
  if (points.size() < fewest) return std::nullopt;
  return Fit(std::move(points), along.normalized(), width);
}

class Beside {
public:
  Beside(const Skeleton& skeleton, const PointDistances& distances, double spacing,
         double exactness, const CheckOptions& options)
      : skeleton_(skeleton), distances_(distances), spacing_(spacing), exactness_(exactness),
        options_(options), pointsOf_(skeleton.idEnd()) {
    for (std::size_t i = 0; i < distances.toSurface().size(); ++i)
      if (std::isfinite(distances.toSurface()[i]))
        pointsOf_[indexOf(distances.nearest()[i])].push_back(static_cast<Eigen::Index>(i));
  }

  /// How far the wood around a node is beside its points, if it is.
  [[nodiscard]] std::optional<double> at(NodeId id) const {
    const double least =
        std::max(options_.besideUnits * exactness_, options_.besideRadii * skeleton_[id].radius);
    const auto eachPoint = [&](NodeId edge, const auto& take) {
      for (const Eigen::Index point : pointsOf_[indexOf(edge)])
        take(distances_.cloud()->position(point));
    };
    const std::optional<Fit> fit = fitAround(skeleton_, id, spacing_, least, eachPoint);
    if (!fit) return std::nullopt;
    const Eigen::Vector3d shift = fit->shift();
    if (shift.norm() <= least) return std::nullopt;
    const double now = fit->distance(Eigen::Vector3d::Zero());
    return 2 * fit->distance(shift) < now ? std::optional(shift.norm()) : std::nullopt;
  }

private:
  const Skeleton& skeleton_;
  const PointDistances& distances_;
  double spacing_;   // [L]
  double exactness_; // [L]
  const CheckOptions& options_;
  std::vector<std::vector<Eigen::Index>> pointsOf_; // by id
};

} // namespace

std::vector<Finding> axesBesidePoints(const Skeleton& skeleton, const PointDistances& distances,
                                      double spacing, double exactness, const CheckOptions& options,
                                      const Progress& progress) {
  if (distances.cloud()->isEmpty() || skeleton.isEmpty() || spacing <= 0) return {};
  const Beside beside(skeleton, distances, spacing, exactness, options);
  const std::vector<NodeId> ids = skeleton.ids();
  std::vector<double> shifts(skeleton.idEnd(), 0); // by id
  const auto look = [&](Eigen::Index i) {
    const NodeId id = ids[static_cast<std::size_t>(i)];
    shifts[indexOf(id)] = beside.at(id).value_or(0);
  };
  parallelFor(static_cast<Eigen::Index>(ids.size()), look, progress, 16);
  std::vector<Finding> findings;
  std::vector<std::size_t> findingOf(skeleton.idEnd());
  for (const NodeId id : ids) {
    if (shifts[indexOf(id)] == 0) continue;
    const auto before = previousOnAxis(skeleton, id);
    const bool goesOn = before && shifts[indexOf(*before)] > 0;
    findingOf[indexOf(id)] = goesOn ? findingOf[indexOf(*before)] : findings.size();
    if (goesOn)
      findings[findingOf[indexOf(id)]].others.push_back(id);
    else
      findings.push_back({.kind = Finding::Kind::besidePoints, .node = id});
    double& amount = findings[findingOf[indexOf(id)]].amount;
    amount = std::max(amount, shifts[indexOf(id)]);
  }
  return findings;
}

std::optional<Eigen::Vector3d> shiftToPoints(const Skeleton& skeleton, NodeId id,
                                             const std::vector<Eigen::Vector3d>& near,
                                             double spacing) {
  const EdgeIndex wood(bodiesOf(skeleton));
  std::map<NodeId, std::vector<Eigen::Vector3d>> ofEdge;
  for (const Eigen::Vector3d& place : near)
    if (const auto nearest = wood.nearest(place)) ofEdge[nearest->node].push_back(place);
  const auto eachPoint = [&](NodeId edge, const auto& take) {
    if (const auto found = ofEdge.find(edge); found != ofEdge.end())
      std::ranges::for_each(found->second, take);
  };
  const CheckOptions limits;
  const double width =
      std::max(limits.besideUnits * spacing, limits.besideRadii * skeleton[id].radius);
  const std::optional<Fit> fit = fitAround(skeleton, id, spacing, width, eachPoint);
  if (!fit) return std::nullopt;
  if (std::optional<Eigen::Vector3d> middle = fit->middleOfBlade()) return middle;
  const Eigen::Vector3d shift = fit->shift();
  const bool isNearer = fit->distance(shift) < fit->distance(Eigen::Vector3d::Zero());
  return isNearer ? std::optional(shift) : std::nullopt;
}

} // namespace espalier
