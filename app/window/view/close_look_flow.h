#pragma once

#include "app/window/frame/window_part.h"
#include "ui/view/close_look.h"

#include <QPointer>

#include <vector>

namespace espalier {

class ActionSet;
class Editing;
class PlantDocument;
class PlantView;
class Scan;
class TwoViewsFlow;
struct Pick;

/// What of the plant to show around the pointer or a selection: a node, edge or point with what is
/// near it; of a point that no wood explains, the branch that is missing there, as far as points
/// are connected; of a point of a preview, or without a skeleton, that alone. Empty: the pointer is
/// on nothing.
/// @param scan null: none
[[nodiscard]] Sight sightOf(const Skeleton& skeleton, const Pick& pick, const Scan* scan);
[[nodiscard]] Sight sightOf(const Skeleton& skeleton, const std::vector<NodeId>& nodes);

/// One key that shows what is under the pointer from near and from where it is seen best, and one
/// that goes back to where one was.
class CloseLookFlow : public WindowPart {
  Q_OBJECT

public:
  /// All must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view; // the first
    ActionSet& actions;
    const Editing& editing;
    const TwoViewsFlow& twoViews;
  };
  explicit CloseLookFlow(const Parts& parts);

private:
  struct Place {
    QPointer<PlantView> view;
    Camera camera;
  };
  void look();
  void goBack();

  Parts parts_;
  std::vector<Place> before_; // the last one last
};

} // namespace espalier
