#include "app/window/frame/view_sync.h"

#include "ui/document/plant_document.h"
#include "ui/view/plant_view.h"

namespace espalier {

ViewSync::ViewSync(PlantDocument& document, PlantView& view, QObject* parent) : QObject(parent) {
  connect(&document, &PlantDocument::scanChanged, &view, [&document, &view] {
    view.setCloud(document.scan() ? document.scan()->cloud() : nullptr);
    view.setPointsLeftOut(document.leftOut());
  });
  connect(&document, &PlantDocument::leftOutChanged, &view,
          [&document, &view] { view.setPointsLeftOut(document.leftOut()); });
  connect(&document, &PlantDocument::contractedChanged, &view,
          [&document, &view] { view.setContracted(document.contracted()); });
  connect(&document, &PlantDocument::skeletonReplaced, &view,
          [&document, &view] { view.setSkeleton(document.skeleton()); });
  connect(&document, &PlantDocument::skeletonEdited, &view,
          [&document, &view](const SkeletonDelta& delta) {
            view.updateSkeleton(document.skeleton(), delta);
          });
  connect(&document.selection(), &Selection::changed, &view,
          [&document, &view] { view.setSelection(document.selection().nodes()); });
  connect(&document, &PlantDocument::unitChanged, &view,
          [&document, &view] { view.setLengthUnit(symbol(document.unit())); });
}

void frameSelection(PlantDocument& document, PlantView& view) {
  Eigen::AlignedBox3d box;
  for (const NodeId id : document.selection().nodes()) {
    const Node& node = document.skeleton()[id];
    box.extend(node.position);
    if (node.parent) box.extend(document.skeleton()[*node.parent].position);
    for (const NodeId child : document.skeleton().children(id))
      box.extend(document.skeleton()[child].position);
  }
  if (box.isEmpty())
    view.frameAll();
  else
    view.frame(box);
}

} // namespace espalier
