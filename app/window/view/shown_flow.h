#pragma once

#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <QString>

#include <vector>

namespace espalier {

class ActionSet;
class ClipPanel;
class Editing;
class PlantDocument;
class PlantView;
struct Camera;

/// What of the plant is shown: hides and isolates nodes, and clips the view. All of it is undone by
/// one command; none of it edits the plant.
class ShownFlow : public WindowPart {
  Q_OBJECT

public:
  /// All must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    ActionSet& actions;
    Editing& editing;
    PanelDock::Parts window; // gets the panel
  };
  explicit ShownFlow(const Parts& parts);

  [[nodiscard]] const std::vector<NodeId>& hidden() const { return hidden_; }
  [[nodiscard]] std::vector<NodeId> shownNodes() const; // those that are not hidden
  void setHidden(const std::vector<NodeId>& nodes);     // ids that are gone are left out
  void showAll();
  /// Shows what one flies to, as it will be seen from `camera`: nodes that are hidden are shown
  /// again, and the slab and the box are moved along.
  /// @param places further ones that are meant, as points of the scan [L]
  /// @return what was changed, for the status line; empty: nothing had to be
  [[nodiscard]] QString reveal(const std::vector<NodeId>& nodes,
                               const std::vector<Eigen::Vector3d>& places, const Camera& camera);
  void setPlantShown(bool isShown) override;
  [[nodiscard]] QString count() const override;
  void setPointsIsolated(bool areIsolated); // points are hidden elsewhere
  void refreshPanel();                      // after the clip of the view was changed elsewhere

signals:
  void hiddenChanged(); // other nodes are hidden

private:
  void addActions();
  void makePanel();
  void hide();
  void isolate();
  void selectShownPoints();
  /// The chosen nodes, else the axis of the node under the pointer.
  /// @throws Error if there is neither
  [[nodiscard]] std::vector<NodeId> meant() const;
  void clipAsPanelSays();
  void refreshEnabled();

  PlantDocument& document_;
  PlantView& view_;
  ActionSet& actions_;
  Editing& editing_;
  PanelDock::Parts window_;
  ClipPanel* panel_ = nullptr;
  std::vector<NodeId> hidden_;
  bool arePointsIsolated_ = false;
};

} // namespace espalier
