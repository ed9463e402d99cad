#include "core/decide/error_evidence.h"

#include "core/base/parallel.h"
#include "core/decide/end_odds.h"
#include "core/decide/gap_odds.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/frustum.h"
#include "core/skeleton/length_along.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace espalier {
namespace {

constexpr std::uint32_t inNoPiece = std::numeric_limits<std::uint32_t>::max();
constexpr double nearReach = 2; // spacings from the surface: where a point stands for wood

/// Finds the evidence of pieces, each kind in its turn.
class PieceEvidence {
public:
  PieceEvidence(const Skeleton& skeleton, const std::vector<Stretch>& pieces,
                const PointDistances& distances, const SpatialIndex& index, const PlantScale& scale,
                const Eigen::Vector3d& up)
      : skeleton_(skeleton), pieces_(pieces), distances_(distances), index_(index), scale_(scale),
        up_(up), pieceOf_(skeleton.idEnd(), inNoPiece), found_(pieces.size()) {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (const NodeId id : pieces[i])
        pieceOf_[indexOf(id)] = static_cast<std::uint32_t>(i);
  }

  [[nodiscard]] std::vector<ErrorEvidence> find(const Progress& progress) {
    measureLengths();
    countPoints();
    addFindings(progress.part(0, 0.3));
    addEnds(progress.part(0.3, 0.6));
    addGaps(progress.part(0.6, 0.7));
    addSurroundings(progress.part(0.7, 1));
    return std::move(found_);
  }

private:
  [[nodiscard]] ErrorEvidence& of(NodeId id) { return found_[pieceOf_[indexOf(id)]]; }

  [[nodiscard]] double spacingsOf(NodeId id) const { // long its edge is
    return edgeLength(skeleton_, id) / scale_.spacing;
  }

  void measureLengths() {
    std::vector<double> below(skeleton_.idEnd(), 0); // of the unbranched run up to a node
    const std::vector<double> above = carriedLengths(skeleton_);
    std::vector<double> run(skeleton_.idEnd(), 0); // of the run that a node is in
    const std::vector<NodeId> ids = skeleton_.ids();
    const auto goesOn = [&](NodeId id) { // the run of its parent
      const auto parent = skeleton_[id].parent;
      return parent && skeleton_.children(*parent).size() == 1;
    };
    for (const NodeId id : ids)
      below[indexOf(id)] =
          spacingsOf(id) + (goesOn(id) ? below[indexOf(*skeleton_[id].parent)] : 0);
    for (auto id = ids.rbegin(); id != ids.rend(); ++id) {
      const std::size_t at = indexOf(*id);
      const std::vector<NodeId>& children = skeleton_.children(*id);
      run[at] = children.size() == 1 ? run[indexOf(children.front())] : below[at];
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (const NodeId id : pieces_[i]) {
        found_[i].length += spacingsOf(id);
        found_[i].radius +=
            skeleton_[id].radius / scale_.spacing / static_cast<double>(pieces_[i].size());
      }
      found_[i].whole = run[indexOf(pieces_[i].front())];
      found_[i].carried = above[indexOf(pieces_[i].back())] / scale_.spacing;
      lookBelow(pieces_[i], found_[i]);
    }
  }

  /// How a piece is attached to what is below it.
  void lookBelow(const Stretch& piece, ErrorEvidence& found) const {
    constexpr int reach = 3; // edges
    found.turn = 1;
    const auto foot = skeleton_[piece.front()].parent;
    if (!foot) return;
    found.branches = nextOnAxis(skeleton_, *foot) != piece.front();
    NodeId low = *foot;
    for (int i = 0; i < reach && skeleton_[low].parent; ++i)
      low = *skeleton_[low].parent;
    const NodeId high = piece[std::min<std::size_t>(piece.size(), reach) - 1];
    const Eigen::Vector3d above = skeleton_[high].position - skeleton_[*foot].position;
    const Eigen::Vector3d under = skeleton_[*foot].position - skeleton_[low].position;
    const double lengths = above.norm() * under.norm();
    if (lengths > 0) found.turn = above.dot(under) / lengths;
  }

  void countPoints() {
    const double reach = CheckOptions().pointReach * scale_.spacing;
    for (std::size_t i = 0; i < distances_.toSurface().size(); ++i) {
      const std::size_t node = indexOf(distances_.nearest()[i]);
      const double distance = distances_.toSurface()[i];
      if (node >= pieceOf_.size() || pieceOf_[node] == inNoPiece || !std::isfinite(distance))
        continue;
      ErrorEvidence& found = found_[pieceOf_[node]];
      if (distance > reach) {
        ++found.unexplained;
        continue;
      }
      ++found.points;
      found.scatter += std::abs(distance) / scale_.spacing;
    }
    for (ErrorEvidence& found : found_)
      found.scatter /= std::max(found.points, 1.0);
  }

  void addFindings(const Progress& progress) {
    for (const Finding& finding : check(skeleton_, scale_.spacing)) {
      if (finding.kind == Finding::Kind::radiusAboveParent) continue;
      if (finding.kind == Finding::Kind::noLength) continue; // nothing of its length is wrong
      for (const NodeId id : nodesOf(finding))
        ++of(id).findings;
    }
    for (const Finding& finding :
         branchesWithoutOwnPoints(skeleton_, distances_, index_, scale_.spacing, {}, progress))
      for (const NodeId id : nodesOf(finding))
        of(id).withoutOwn = std::max(of(id).withoutOwn, finding.amount / scale_.spacing);
  }

  void addEnds(const Progress& progress) {
    if (skeleton_.isEmpty()) return;
    const PointCloud& cloud = *distances_.cloud();
    const EndsOfSkeleton ends(skeleton_, cloud.positions(), cloud.origin(), scale_, progress);
    for (const EndsOfSkeleton::End& end : ends.ends()) {
      const double shoot = probabilityOfShoot(end.evidence);
      for (const NodeId id : end.end.nodes) {
        of(id).isEnd = true;
        of(id).end = std::log(shoot / (1 - shoot));
      }
    }
  }

  void addGaps(const Progress& progress) {
    const GapOptions usual;
    const auto length = [&](const Length& from) { return Length(from.rule().value(scale_)); };
    const GapOptions options{.widest = length(usual.widest),
                             .reach = length(usual.reach),
                             .turnCost = usual.turnCost,
                             .backCost = length(usual.backCost)};
    const Gaps gaps = gapsIn(skeleton_, options, progress);
    const std::vector<double> odds = probabilitiesOf(gaps, scale_.spacing, up_);
    std::vector<const GapLink*> there(gaps.entries.size()); // by the fragment that it bears
    for (const GapLink& link : gaps.links)
      if (link.evidence.isThere) there[link.borne] = &link;
    for (std::size_t i = 0; i < gaps.links.size(); ++i) {
      const GapLink& link = gaps.links[i];
      if (const GapLink* now = there[link.borne];
          now && !isAlike(skeleton_, link, *now, alikeWithin * scale_.spacing))
        of(now->to).gap += odds[i];
    }
  }

  void addSurroundings(const Progress& progress) {
    const EdgeIndex wood(bodiesOf(skeleton_));
    const auto look = [&](Eigen::Index i) {
      const auto at = static_cast<std::size_t>(i);
      found_[at].inAir = shareInAir(pieces_[at]);
      found_[at].beside = besideOf(pieces_[at], wood);
    };
    parallelFor(static_cast<Eigen::Index>(pieces_.size()), look, progress, 16);
  }

  [[nodiscard]] double shareInAir(const Stretch& piece) const {
    constexpr double most = 1000; // steps: one edge across a plant of many points
    double all = 0, inAir = 0;
    for (const NodeId id : piece) {
      const auto body = frustumOf(skeleton_, id);
      if (!body || !skeleton_[id].parent) continue;
      const double steps = std::clamp(std::ceil(body->length() / scale_.spacing), 1.0, most);
      for (double step = 0.5; step < steps; ++step) {
        const Eigen::Vector3f place =
            (body->at(step / steps) - distances_.cloud()->origin()).cast<float>();
        const double reach = body->radiusAt(step / steps) + nearReach * scale_.spacing;
        const double length = body->length() / steps;
        all += length;
        if (!index_.nearestOne(place, static_cast<float>(reach))) inAir += length;
      }
    }
    return all > 0 ? inAir / all : 0;
  }

  /// From the middle of a piece to wood that it is not connected to.
  [[nodiscard]] double besideOf(const Stretch& piece, const EdgeIndex& wood) const {
    const NodeId middle = piece[piece.size() / 2];
    const std::optional<NodeId> below = skeleton_[piece.front()].parent;
    const Eigen::Vector3d place = centerLine(skeleton_, middle).at(0.5);
    const double distance = wood.distanceToSurface(place, [&](NodeId id) {
      const std::optional<NodeId> parent = skeleton_[id].parent;
      return pieceOf_[indexOf(id)] != pieceOf_[indexOf(middle)] && id != below &&
             parent != piece.back() && (!parent || parent != below);
    });
    constexpr double farAway = 100; // spacings
    return std::min(distance / scale_.spacing, farAway);
  }

  const Skeleton& skeleton_;
  const std::vector<Stretch>& pieces_;
  const PointDistances& distances_;
  const SpatialIndex& index_;
  const PlantScale& scale_;
  const Eigen::Vector3d& up_;
  std::vector<std::uint32_t> pieceOf_; // by id
  std::vector<ErrorEvidence> found_;   // by piece
};

} // namespace

double ratedLength(const PlantScale& scale) {
  return 30 * scale.spacing;
}

std::vector<ErrorEvidence> errorEvidence(const Skeleton& skeleton,
                                         const std::vector<Stretch>& pieces,
                                         const PointDistances& distances, const SpatialIndex& index,
                                         const PlantScale& scale, const Eigen::Vector3d& up,
                                         const Progress& progress) {
  return PieceEvidence(skeleton, pieces, distances, index, scale, up).find(progress);
}

} // namespace espalier
