#include "core/surface/envelopes/crown.h"

#include "core/base/qhull.h"
#include "core/base/shown_message.h"

#include <numeric>
#include <set>
#include <string>

namespace espalier {
namespace {

using Columns = std::vector<Eigen::Index>;

/// Which of some columns are corners of their convex hull; all if they fill no space.
Columns cornersAmong(const Eigen::Matrix3Xd& points, const Columns& columns) {
  if (columns.size() < 5) return columns;
  const Spread<3> spread(Eigen::Matrix3Xd(points(Eigen::all, columns)));
  if (!spread.isSolid()) return columns;
  Columns corners;
  for (const Eigen::Index corner : Facets(spread.centered).corners())
    corners.push_back(columns[static_cast<std::size_t>(corner)]);
  return corners;
}

/// The same by parts, whose corners have all of the whole: so it can be stopped in between.
Columns cornersByParts(const Eigen::Matrix3Xd& points, const Columns& columns,
                       const Progress& progress) {
  constexpr std::size_t part = 20'000;
  Columns corners;
  for (std::size_t begin = 0; begin < columns.size(); begin += part) {
    progress.check();
    const auto from = columns.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto to =
        from + static_cast<std::ptrdiff_t>(std::min<std::size_t>(part, columns.size() - begin));
    const Columns some = cornersAmong(points, Columns(from, to));
    corners.insert(corners.end(), some.begin(), some.end());
  }
  progress.check();
  return columns.size() > part ? cornersAmong(points, corners) : corners;
}

/// Without the outermost, of which `most` may go.
Columns peeled(const Eigen::Matrix3Xd& points, Columns columns, std::size_t most,
               const Progress& progress) {
  const std::size_t least = columns.size() - most;
  while (columns.size() > least) {
    const Columns corners = cornersByParts(points, columns, progress);
    if (columns.size() - corners.size() < std::max<std::size_t>(least, 5)) break;
    const std::set<Eigen::Index> outer(corners.begin(), corners.end());
    std::erase_if(columns, [&](Eigen::Index column) { return outer.contains(column); });
  }
  return columns;
}

void requirePoints(const Eigen::Matrix3Xd& points) {
  if (!points.allFinite())
    throw ShownError(
        {Shown::tr("a position is no number: repair it, or leave it out of the envelope")});
  if (points.cols() < 4)
    throw ShownError(
        points.cols() == 1
            ? ShownMessage{Shown::tr(
                  "there is 1 point: an envelope needs 4 or more that fill space")}
            : ShownMessage{
                  Shown::tr("there are %1 points: an envelope needs 4 or more that fill space"),
                  {std::to_string(points.cols())}});
}

} // namespace

Crown crownOf(const Eigen::Matrix3Xd& points, double within, const Progress& progress) {
  requirePoints(points);
  Columns columns(static_cast<std::size_t>(points.cols()));
  std::iota(columns.begin(), columns.end(), Eigen::Index{0});
  const auto most =
      static_cast<std::size_t>((1 - within) * static_cast<double>(columns.size()) + 1e-9);
  if (most > 0) columns = peeled(points, std::move(columns), most, progress);
  Crown crown{.points = points(Eigen::all, columns), .hull = {}};
  const auto hull =
      convexHull(Eigen::Matrix3Xd(points(Eigen::all, cornersByParts(points, columns, progress))));
  if (!hull)
    throw ShownError({Shown::tr("the points lie in a plane, on a line or at one place: an envelope "
                                "needs points that fill space")});
  crown.hull = *hull;
  return crown;
}

double bottomOf(const Crown& crown) {
  return crown.hull.corners.row(2).minCoeff();
}

double topOf(const Crown& crown) {
  return crown.hull.corners.row(2).maxCoeff();
}

} // namespace espalier
