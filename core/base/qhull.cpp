#include "core/base/qhull.h"

#include "core/base/shown_message.h"

#include <Eigen/Geometry>

#include <string>
#include <utility>

namespace espalier {

Facets::Facets(Eigen::MatrixXd points) : points_(std::move(points)) {
  qh_zero(&qh_, stderr);
  std::string command = "qhull Qt Pp";
  if (qh_new_qhull(&qh_, static_cast<int>(points_.rows()), static_cast<int>(points_.cols()),
                   points_.data(), False, command.data(), nullptr, nullptr) != qh_ERRnone) {
    free();
    throw ShownError({Shown::tr("the convex hull of the points could not be found")});
  }
  qh_getarea(&qh_, qh_.facet_list);
}

Facets::~Facets() {
  free();
}

std::vector<Eigen::Index> Facets::corners() const {
  std::vector<Eigen::Index> result;
  for (const vertexT* vertex = qh_.vertex_list; vertex->next != nullptr; vertex = vertex->next)
    result.push_back(qh_pointid(&qh_, vertex->point));
  return result;
}

std::vector<std::array<int, 3>> Facets::triangles() const {
  std::vector<std::array<int, 3>> result;
  for (const facetT* facet = qh_.facet_list; facet->next != nullptr; facet = facet->next) {
    std::array<int, 3> triangle{};
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i] = qh_pointid(&qh_, SETelemt_(facet->vertices, i, vertexT)->point);
    const auto at = [&](std::size_t i) { return points_.col(triangle[i]).head<3>(); };
    const Eigen::Map<const Eigen::Vector3d> out(facet->normal);
    if ((at(1) - at(0)).cross(at(2) - at(0)).dot(out) < 0) std::swap(triangle[1], triangle[2]);
    result.push_back(triangle);
  }
  return result;
}

void Facets::free() {
  qh_freeqhull(&qh_, !qh_ALL); // large blocks, then the small ones
  int blocks = 0;
  int bytes = 0;
  qh_memfreeshort(&qh_, &blocks, &bytes);
}

} // namespace espalier
