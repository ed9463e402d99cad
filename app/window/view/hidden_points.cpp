#include "app/window/view/hidden_points.h"

#include "app/window/edit/point_states.h"
#include "app/window/frame/scan_distances.h"
#include "app/window/view/shown_flow.h"
#include "ui/document/plant_document.h"

namespace espalier {

HiddenPoints::HiddenPoints(const Parts& parts) : parts_(parts) {
  connect(&parts_.shown, &ShownFlow::hiddenChanged, this, [this] {
    parts_.distances.setWanted(ScanDistances::Use::hidden, !parts_.shown.hidden().empty());
    refresh();
  });
  timer_.setSingleShot(true);
  timer_.setInterval(200); // [ms]: not while the mouse moves a node
  connect(&timer_, &QTimer::timeout, this, &HiddenPoints::refresh);
  connect(&parts_.distances, &ScanDistances::changed, &timer_, qOverload<>(&QTimer::start));
}

void HiddenPoints::refresh() {
  const std::vector<NodeId>& hidden = parts_.shown.hidden();
  if (hidden.empty()) return parts_.states.hide({});
  const auto distances = parts_.distances.now();
  if (!distances) return; // as before, until they are measured
  std::vector<bool> isHidden(parts_.document.skeleton().idEnd(), false);
  for (const NodeId id : hidden)
    if (indexOf(id) < isHidden.size()) isHidden[indexOf(id)] = true;
  std::vector<Eigen::Index> points;
  const std::vector<NodeId>& nearest = distances->nearest();
  for (std::size_t point = 0; point < nearest.size(); ++point)
    if (isHidden[indexOf(nearest[point])]) points.push_back(static_cast<Eigen::Index>(point));
  parts_.states.hide(parts_.distances.inScan(points));
}

} // namespace espalier
