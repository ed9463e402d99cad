#include "core/evaluate/match/barcode.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>

namespace espalier {
namespace {

constexpr double deviation = 0.05; // of a spot, where the longest bar is 1
constexpr double border = 3 * deviation;
constexpr int cells = 130; // along a side: five in a deviation

double reachOf(const std::vector<Bar>& bars) {
  double reach = 0;
  for (const Bar& bar : bars)
    reach = std::max(reach, bar.to);
  return reach;
}

/// A spot along one side; its sum is 1.
Eigen::VectorXd spotAt(double place) {
  constexpr double cell = (1 + 2 * border) / cells;
  Eigen::VectorXd spot(cells);
  for (int i = 0; i < cells; ++i)
    spot[i] = std::exp(-0.5 * std::pow(((i + 0.5) * cell - border - place) / deviation, 2));
  return spot / spot.sum();
}

Eigen::MatrixXd pictureOf(const std::vector<Bar>& bars, double longest) {
  Eigen::MatrixXd picture = Eigen::MatrixXd::Zero(cells, cells);
  for (const Bar& bar : bars)
    picture += spotAt(bar.from / longest) * spotAt(bar.to / longest).transpose();
  return picture;
}

} // namespace

std::vector<Bar> barcode(const Skeleton& skeleton) {
  const std::vector<NodeId> ids = skeleton.ids(); // parents before their children
  std::vector<double> height(skeleton.idEnd(), 0);
  for (const NodeId id : ids)
    if (const auto& parent = skeleton[id].parent)
      height[indexOf(id)] =
          height[indexOf(*parent)] + (skeleton[id].position - skeleton[*parent].position).norm();
  std::vector<Bar> bars;
  std::vector<double> reach(skeleton.idEnd(), 0); // of what a node carries
  for (auto at = ids.rbegin(); at != ids.rend(); ++at) {
    const NodeId id = *at;
    const std::vector<NodeId>& children = skeleton.children(id);
    std::optional<NodeId> farthest;
    for (const NodeId child : children)
      if (!farthest || reach[indexOf(child)] > reach[indexOf(*farthest)]) farthest = child;
    for (const NodeId child : children)
      if (child != farthest) bars.push_back({height[indexOf(id)], reach[indexOf(child)]});
    reach[indexOf(id)] = farthest ? reach[indexOf(*farthest)] : height[indexOf(id)];
    if (!skeleton[id].parent && farthest) bars.push_back({0, reach[indexOf(id)]});
  }
  return bars;
}

double barcodeDistance(const std::vector<Bar>& a, const std::vector<Bar>& b) {
  const double longest = std::max(reachOf(a), reachOf(b));
  if (longest == 0) return 0;
  const Eigen::MatrixXd first = pictureOf(a, longest);
  const Eigen::MatrixXd second = pictureOf(b, longest);
  return (first - second).cwiseAbs().sum() / (first.sum() + second.sum());
}

} // namespace espalier
