#pragma once

#include "ui/document/plant_document.h"
#include "ui/jobs/job_runner.h"

#include <QMainWindow>

#include <memory>

class QSettings;
class QSplitter;
class QStackedWidget;

namespace espalier {

enum class Refusal;
class ActionSet;
class ChoicesFlow;
class CloseLookFlow;
class DensityFlow;
class Editing;
class EvaluationFlow;
class ExplainedFlow;
class FileFlow;
class FindingsFlow;
class HistoryFlow;
class HullFlow;
class JudgeFlow;
class InspectorPanel;
class KeyBindings;
class MessageBanner;
class NodeTableFlow;
class PanelDock;
class PipelinePanel;
class PlantView;
class PointStates;
class PointsFlow;
class PresetFlow;
class PreviewFlow;
class ProjectFlow;
class RadiusFlow;
class RecentFiles;
class ReconstructFlow;
class ReferenceFlow;
class ReviewFlow;
class ScanDistances;
class SealFlow;
class SavedViews;
class ShownFlow;
class SightFlow;
struct Step;
class SnapFlow;
class StandFlow;
class SweepFlow;
class StartPage;
class StatesFlow;
class StatusLine;
class TraceFlow;
class ThemeFlow;
class TwoViewsFlow;
class UnitFlow;
class ValueColors;
class VertexPage;
class ViewOptions;
class ViewSync;

/// The window: joins document, view, panels and actions, and decides nothing itself.
class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  /// @param settings must outlive the window
  explicit MainWindow(QSettings& settings, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Opens files as if they had been dropped here.
  void open(const QStringList& paths);

  [[nodiscard]] PlantDocument& document() { return document_; }
  [[nodiscard]] JobRunner& jobs() { return jobs_; }
  [[nodiscard]] PlantView& view() { return *view_; }
  [[nodiscard]] const ActionSet& actionSet() const { return *actions_; }
  [[nodiscard]] const PreviewFlow& preview() const { return *preview_; }
  [[nodiscard]] const MessageBanner& banner() const { return *banner_; }
  [[nodiscard]] const StatusLine& statusLine() const { return *status_; }

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void addActions();        // main_window_actions.cpp
  void addFileActions();    // likewise
  void addProjectActions(); // likewise
  void addEditActions();    // likewise
  void addPanels();         // likewise
  void addHelpActions();    // likewise
  void fillMenus();         // menus.cpp
  void fillViewMenu();      // likewise
  void fillToolBar();       // likewise
  void connectJobs();       // main_window_connections.cpp
  void connectFiles();      // likewise
  void connectProjects();   // likewise
  void connectDocument();   // likewise
  void connectReview();     // likewise
  void connectFindings();   // likewise
  void connectAtHand();     // likewise
  void connectEvaluation(); // likewise
  void connectPreview();    // likewise
  void makeCenter();
  void closePlant();
  void tellStep(int index);
  void refreshDocks();
  void refreshTitle();
  void refreshCounts();
  void refreshHint();
  void refreshEmptiness();
  void reconstruct(const Step* last = nullptr); // up to a step
  void leave();
  void undoStep();
  void redoStep();
  [[nodiscard]] bool endsPreview(int step); // of the undo stack
  void resetLayout();
  void showRefusal(const QString& reason, Refusal where);
  void showContextMenu(const QPoint& globalPosition);

  QSettings& settings_;
  PlantDocument document_;
  JobRunner jobs_;
  std::unique_ptr<RecentFiles> recent_;
  std::unique_ptr<ActionSet> actions_;

  PlantView* view_;
  QSplitter* views_; // beside it there may be a second
  StartPage* start_;
  VertexPage* vertices_; // of a plant without positions
  QStackedWidget* center_;
  MessageBanner* banner_;
  QString refusal_; // the last one told in the banner
  StatusLine* status_;
  PipelinePanel* pipeline_;
  InspectorPanel* inspector_;
  PanelDock* pipelineDock_ = nullptr;
  PanelDock* inspectorDock_ = nullptr;

  int step_ = 0; // of the undo stack, when it was told last
  std::unique_ptr<ViewSync> sync_;
  std::unique_ptr<Editing> editing_;
  std::unique_ptr<TwoViewsFlow> twoViews_;
  std::unique_ptr<CloseLookFlow> closeLook_;
  std::unique_ptr<TraceFlow> traces_;
  std::unique_ptr<SnapFlow> snaps_;
  std::unique_ptr<StandFlow> stand_;
  std::unique_ptr<PointStates> pointStates_;
  std::unique_ptr<PointsFlow> points_;
  std::unique_ptr<UnitFlow> units_;
  std::unique_ptr<RadiusFlow> radius_;
  std::unique_ptr<SealFlow> seals_;
  std::unique_ptr<ReviewFlow> review_;
  std::unique_ptr<ShownFlow> shown_;
  std::unique_ptr<ScanDistances> distances_;
  std::unique_ptr<FindingsFlow> findings_;
  std::unique_ptr<ExplainedFlow> explained_;
  std::unique_ptr<HullFlow> hulls_;
  std::unique_ptr<PresetFlow> presets_;
  std::unique_ptr<HistoryFlow> history_;
  std::unique_ptr<NodeTableFlow> nodeTable_;
  ThemeFlow* theme_;
  KeyBindings* keys_ = nullptr;
  std::unique_ptr<ViewOptions> options_;
  std::unique_ptr<SavedViews> savedViews_;
  std::unique_ptr<ValueColors> valueColors_;
  std::unique_ptr<ReferenceFlow> reference_;
  std::unique_ptr<EvaluationFlow> evaluation_;
  std::unique_ptr<ChoicesFlow> choices_;
  std::unique_ptr<ReconstructFlow> reconstruct_;
  std::unique_ptr<ProjectFlow> projects_; // behind all that it keeps: writes that as it goes
  std::unique_ptr<FileFlow> files_;
  std::unique_ptr<PreviewFlow> preview_;
  std::unique_ptr<StatesFlow> states_;
  std::unique_ptr<DensityFlow> densities_;
  std::unique_ptr<JudgeFlow> judge_;
  std::unique_ptr<SweepFlow> sweep_;
  std::unique_ptr<SightFlow> sight_;
};

} // namespace espalier
