#include "core/base/delaunay.h"

#include "core/base/qhull.h"
#include "core/base/random.h"
#include "core/base/shown_message.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <csetjmp>
#include <limits>
#include <utility>

namespace espalier {
namespace {

/// Qhull's state, which is freed with it.
class LiftedHull {
public:
  LiftedHull() {
    qh_zero(&state, stderr);
    qh_initqhull_start(&state, nullptr, nullptr, stderr);
  }
  ~LiftedHull() {
    state.NOerrexit = True; // nothing to jump to any more
    qh_freeqhull(&state, !qh_ALL);
    int blocks = 0;
    int bytes = 0;
    qh_memfreeshort(&state, &blocks, &bytes);
  }
  LiftedHull(const LiftedHull&) = delete;
  LiftedHull& operator=(const LiftedHull&) = delete;

  qhT state{};
};

/// qh_buildhull(), which cannot be stopped. Has nothing that a jump out of it would leave behind.
void addPoints(qhT& state, const Progress& progress, int count) {
  facetT* facet = nullptr;
  int added = 0;
  while (pointT* furthest = qh_nextfurthest(&state, &facet)) {
    --state.num_outside;
    if (++added % 64 == 0)
      progress.update(std::min(1.0, static_cast<double>(added) / static_cast<double>(count)));
    if (qh_addpoint(&state, furthest, facet, state.ONLYmax) == False) break;
  }
}

/// @return 0, or Qhull's number of what is wrong: it jumps out of its functions
int build(qhT& state, Eigen::Matrix3Xd& points, char* command, const Progress& progress) {
  const auto count = static_cast<int>(points.cols());
  const int failure = setjmp(state.errexit); // NOLINT(cert-err52-cpp): so it is in C
  if (failure != 0) return failure;
  state.NOerrexit = False;
  qh_initflags(&state, command);
  state.PROJECTdelaunay = True;
  qh_init_B(&state, points.data(), count, 3, False);
  qh_initbuild(&state);
  addPoints(state, progress, count);
  qh_prepare_output(&state);
  state.NOerrexit = True;
  return 0;
}

/// About their middle, in units of their extent, and a little beside their places.
Eigen::Matrix3Xd besidePlaces(const Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d low = points.rowwise().minCoeff();
  const Eigen::Vector3d high = points.rowwise().maxCoeff();
  const double size = (high - low).maxCoeff();
  Eigen::Matrix3Xd beside = (points.colwise() - (low + high) / 2) / size;
  const double reach = 1e-4 / std::cbrt(static_cast<double>(points.cols()));
  Random random(1);
  for (auto point : beside.colwise())
    point += reach * random.uniform() * random.direction();
  return beside;
}

double radiusAround(const Eigen::Matrix3Xd& places, const std::array<int, 4>& corners) {
  Eigen::Matrix3d sides;
  Eigen::Vector3d squares;
  for (Eigen::Index i = 0; i < 3; ++i) {
    sides.row(i) =
        (places.col(corners[static_cast<std::size_t>(i) + 1]) - places.col(corners[0])).transpose();
    squares[i] = sides.row(i).squaredNorm() / 2;
  }
  const double radius = sides.partialPivLu().solve(squares).norm();
  return std::isfinite(radius) ? radius : std::numeric_limits<double>::infinity();
}

double turnOf(const Eigen::Matrix3Xd& places, const std::array<int, 4>& corners) {
  const auto side = [&](std::size_t i) {
    return Eigen::Vector3d(places.col(corners[i]) - places.col(corners[0]));
  };
  return side(1).cross(side(2)).dot(side(3));
}

/// The facets below, each a tetrahedron, by Qhull's numbers.
std::vector<Tetrahedron> lowerFacets(qhT& state, const Eigen::Matrix3Xd& places) {
  std::vector<const facetT*> facets;
  for (facetT* facet = state.facet_list; facet->next != nullptr; facet = facet->next) {
    facet->visitid = 0; // none of the tetrahedra
    if (facet->upperdelaunay != 0U || facet->simplicial == 0U) continue;
    facets.push_back(facet);
    facet->visitid = static_cast<unsigned>(facets.size());
  }
  std::vector<Tetrahedron> all;
  for (const facetT* facet : facets) {
    Tetrahedron each;
    each.neighbors.fill(-1);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto* vertex = SETelemt_(facet->vertices, i, vertexT);
      each.corners[i] = qh_pointid(&state, vertex->point);
    }
    const int count = qh_setsize(&state, facet->neighbors);
    for (int n = 0; n < count; ++n) {
      const auto* neighbor = SETelemt_(facet->neighbors, n, facetT);
      if (neighbor->visitid == 0) continue;
      for (std::size_t i = 0; i < 4; ++i)
        if (qh_setin(neighbor->vertices, SETelemt_(facet->vertices, i, vertexT)) == 0)
          each.neighbors[i] = static_cast<int>(neighbor->visitid) - 1;
    }
    if (turnOf(places, each.corners) < 0) {
      std::swap(each.corners[2], each.corners[3]);
      std::swap(each.neighbors[2], each.neighbors[3]);
    }
    each.radius = radiusAround(places, each.corners);
    all.push_back(each);
  }
  return all;
}

} // namespace

std::vector<Tetrahedron> delaunay(const Eigen::Matrix3Xd& points, const Progress& progress) {
  Eigen::Matrix3Xd places = besidePlaces(points);
  const Eigen::Matrix3Xd kept = places;
  LiftedHull hull;
  std::string command = "qhull d Qbb Qt Pp";
  if (build(hull.state, places, command.data(), progress) != qh_ERRnone)
    throw ShownError({Shown::tr("the Delaunay triangulation of the points could not be found")});
  std::vector<Tetrahedron> all = lowerFacets(hull.state, kept);
  const double size = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
  for (Tetrahedron& each : all)
    each.radius *= size;
  return all;
}

} // namespace espalier
