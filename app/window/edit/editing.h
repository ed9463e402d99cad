#pragma once

#include "app/window/edit/active_canvas.h"
#include "app/window/frame/window_part.h"
#include "ui/tools/node_edits.h"
#include "ui/tools/registry.h"
#include "ui/tools/tool.h"

#include <QList>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

class QAction;
class QActionGroup;
class QMenu;

namespace espalier {

class ActionSet;
class PlantView;

/// Joins tools, keys and the 3D view: decides which tool hears the mouse, and what a key means.
class Editing : public WindowPart {
  Q_OBJECT

public:
  /// @param entries the tools; the first is the default
  Editing(PlantDocument& document, PlantView& view, ActionSet& actions,
          std::vector<ToolEntry> entries = tools());
  ~Editing() override;

  /// While a part has the mouse, no tool hears it. Empty: the tools have it again.
  using Borrower = std::function<bool(const ToolInput&)>;
  void borrow(Borrower handler) { borrower_ = std::move(handler); }

  /// Another view of the plant, in which tools and keys work as in the first.
  void addView(PlantView& view);
  void removeView(PlantView& view);

  /// While off, the mouse only moves the camera, and no key edits.
  void setEnabled(bool isEnabled) override;

  [[nodiscard]] bool isBusy() const override { return tool().isBusy(); } // in mid-gesture
  [[nodiscard]] bool hasPreview() const { return tool().hasPreview(); }
  /// In mid-gesture, or with a preview that waits for a yes: Enter and Escape belong to the tool.
  [[nodiscard]] bool isPending() const { return tool().isBusy() || tool().hasPreview(); }

  [[nodiscard]] QString hint() const override;
  [[nodiscard]] QString currentTool() const { return tool_; }                 // its id
  [[nodiscard]] QString manualPlace() const { return currentEntry().manual; } // of that tool
  /// @param startsWithNodes  it begins with the node under the pointer, or those selected
  void useTool(const QString& id, bool startsWithNodes = true);
  [[nodiscard]] Tool& toolNamed(const QString& id) const { return *tools_.at(id); }

  /// What the tool has found, as a length; empty: nothing.
  [[nodiscard]] QString result() const { return tool().result(); }

  void accept(); // what the preview shows, if there is one
  void undo();   // in mid-gesture: leaves the gesture
  void redo();
  void
  escape(); // leaves the gesture or drops the preview, else leaves the tool, else the selection

  /// Keys act on what is selected, whatever the pointer is on, until it moves.
  void actOnSelected();
  void actOnPointed(); // again

  [[nodiscard]] const Pick& under() const { return under_; } // the pointer, as last reported
  [[nodiscard]] std::optional<QPointF> pointer() const; // in the active view; none once it left
  [[nodiscard]] PlantView& activeView() const { return canvas_.view(); } // the pointer was in last
  /// The node that Enter gives the tool: the one that is selected, if it has a use for that.
  [[nodiscard]] std::optional<NodeId> offered() const;
  /// The node under the pointer, or the one that the edge there leads to.
  [[nodiscard]] std::optional<NodeId> nodeUnder() const;

signals:
  void pointed(); // under() was set anew
  void contextMenuRequested(const QPoint& globalPosition);

private:
  void addTools();
  void addToMenus();
  void fillContextMenu(QMenu& menu) const;
  void addNodeEdits();
  void make(const NodeEdit& edit);
  void addNodeChoices();
  void addNavigation();
  void keepToViews(QAction* action);
  void showStep();
  void addDepth();
  void listenTo(PlantView& view);
  bool handle(PlantView& view, const ToolInput& input);
  [[nodiscard]] bool isMenuClick(const ToolInput& input);
  void refreshEnabled();
  [[nodiscard]] bool canEdit() const { return isEnabled_ && !document_.isReadOnly(); }
  [[nodiscard]] bool canUse(const ToolEntry& entry) const {
    return isEnabled_ && (entry.isForLooking || !document_.isReadOnly());
  }
  [[nodiscard]] const ToolEntry& currentEntry() const;
  [[nodiscard]] NodeTarget target() const;
  [[nodiscard]] NodeTarget chosenTarget(bool takesEdge = false); // whose nodes are selected then
  [[nodiscard]] NodeTarget chosenTarget(const NodeEdit& edit);
  [[nodiscard]] std::optional<Eigen::Vector3d> placeUnder() const;
  [[nodiscard]] QString titleUnder() const;
  [[nodiscard]] Tool& tool() const { return *tools_.at(tool_); }

  PlantDocument& document_;
  ActiveCanvas canvas_;
  ActionSet& actions_;
  std::vector<ToolEntry> entries_;
  std::map<QString, std::unique_ptr<Tool>> tools_; // by id
  QString tool_;
  QString toolBefore_;
  QActionGroup* toolGroup_;
  QAction* accept_ = nullptr; // off while there is no preview
  QList<QAction*> edits_;     // off while there is no skeleton, or it may not be edited
  QList<QAction*> choices_;   // of nodes: off while there is no skeleton
  QList<QAction*> ofViews_;   // whose keys work in views alone
  QObject* wheel_ = nullptr;  // filters the events of each view
  Borrower borrower_;         // of the mouse; empty: none
  bool isEnabled_ = true;
  std::optional<QPointF> restsAt_; // the pointer, and is not meant by keys
  Pick under_;
  QPointF pointer_;                  // in the active view, as last reported
  std::optional<QPointF> menuPress_; // where the right button went down, until it is a drag
  Eigen::Vector3d viewDirection_ = Eigen::Vector3d::UnitY();
};

} // namespace espalier
