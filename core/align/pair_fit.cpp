#include "core/align/pair_fit.h"

#include "core/base/coordinates.h"
#include "core/base/shown_message.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <string>

namespace espalier {
namespace {

/// How far places spread along the directions that they spread most along, the most first [L].
Eigen::Vector3d spreadOf(const Eigen::Matrix3Xd& places) {
  const Eigen::Matrix3Xd about = places.colwise() - places.rowwise().mean();
  return about.jacobiSvd().singularValues().head<3>() /
         std::sqrt(static_cast<double>(places.cols()));
}

void requirePlane(const Eigen::Vector3d& spread, const char* atOnePlace, const char* onALine) {
  if (!(spread[0] > 0)) throw ShownError({atOnePlace});
  if (spread[1] < 0.01 * spread[0]) throw ShownError({onALine});
}

} // namespace

PairFit fitPairs(const std::vector<TargetPair>& pairs) {
  const auto count = static_cast<Eigen::Index>(pairs.size());
  if (count < 3)
    throw count == 1
        ? ShownError(
              {Shown::tr("1 pair of targets leave open how the scan lies: pick three or more")})
        : ShownError(
              {Shown::tr("%1 pairs of targets leave open how the scan lies: pick three or more"),
               {std::to_string(count)}});
  Eigen::Matrix3Xd moved(3, count);
  Eigen::Matrix3Xd fixed(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const TargetPair& pair = pairs[static_cast<std::size_t>(i)];
    if (!isInRange(pair.moved) || !isInRange(pair.fixed))
      throw ShownError(
          {Shown::tr("pair %1: a coordinate is no number, or beyond 1e12: correct or remove it"),
           {std::to_string(i + 1)}});
    moved.col(i) = pair.moved;
    fixed.col(i) = pair.fixed;
  }
  const Eigen::Vector3d ofMoved = spreadOf(moved);
  const Eigen::Vector3d ofFixed = spreadOf(fixed);
  requirePlane(ofMoved,
               Shown::tr("the targets of the moved scan lie at one place: pick them far apart"),
               Shown::tr("the targets of the moved scan lie on a line, about which it could turn: "
                         "pick another beside it"));
  requirePlane(ofFixed,
               Shown::tr("the targets of the fixed scan lie at one place: pick them far apart"),
               Shown::tr("the targets of the fixed scan lie on a line, about which it could turn: "
                         "pick another beside it"));
  if (ofMoved.norm() > 2 * ofFixed.norm() || ofFixed.norm() > 2 * ofMoved.norm())
    throw ShownError(
        {Shown::tr("the targets of one scan are over twice as far apart as those of the other: "
                   "check the pairs, and that both scans are in one unit")});

  const Eigen::Vector3d from = moved.rowwise().mean();
  const Eigen::Vector3d to = fixed.rowwise().mean();
  const Eigen::Matrix3d products = (fixed.colwise() - to) * (moved.colwise() - from).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones(); // no mirror image
  signs[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  PairFit fit;
  fit.motion.linear() = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  fit.motion.translation() = to - fit.motion.linear() * from;
  for (Eigen::Index i = 0; i < count; ++i) // about the middles: coordinates of maps are large
    fit.residuals.push_back(
        (fit.motion.linear() * (moved.col(i) - from) - (fixed.col(i) - to)).norm());
  fit.rms = rmsOf(fit.residuals);
  return fit;
}

std::vector<double> distancesApart(const std::vector<TargetPair>& pairs,
                                   const Eigen::Isometry3d& motion) {
  std::vector<double> distances;
  distances.reserve(pairs.size());
  for (const TargetPair& pair : pairs)
    distances.push_back((motion * pair.moved - pair.fixed).norm());
  return distances;
}

double rmsOf(const std::vector<double>& distances) {
  double squares = 0;
  for (const double distance : distances)
    squares += distance * distance;
  return distances.empty() ? 0 : std::sqrt(squares / static_cast<double>(distances.size()));
}

bool tookTargetsApart(double rms, double rmsByPairs, double spacing) {
  return rms > 3 * rmsByPairs && rms > spacing;
}

} // namespace espalier
