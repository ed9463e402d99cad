#pragma once

#include "app/window/frame/reveal.h"
#include "app/window/frame/window_parts.h"
#include "ui/document/plant_document.h"
#include "ui/jobs/job_slot.h"

#include <QMainWindow>

#include <memory>

class QSettings;
class QSplitter;
class QStackedWidget;

namespace espalier {

enum class Refusal;
class ActionSet;
class InspectorPanel;
class MessageBanner;
class PipelinePanel;
class PlantView;
class RecentFiles;
class StartPage;
class StatusLine;
class VertexPage;
class ViewSync;

/// The window: document, view, messages and actions, which its parts work with. It knows no single
/// part but where they are made.
class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  /// @param settings must outlive the window
  explicit MainWindow(QSettings& settings, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Opens files as if they had been dropped here.
  void open(const QStringList& paths);
  /// Reports that a run before crashed.
  /// @param project  what was worked on, which can be opened; empty: nothing
  void showCrash(const QString& project, const QString& log);

  [[nodiscard]] PlantDocument& document() { return document_; }
  [[nodiscard]] JobSlot& jobs() { return jobs_; }
  [[nodiscard]] PlantView& view() { return *view_; }
  [[nodiscard]] const ActionSet& actionSet() const { return *actions_; }
  template <class Part> [[nodiscard]] const Part& part() const { return parts_.get<Part>(); }
  [[nodiscard]] const MessageBanner& banner() const { return *banner_; }
  [[nodiscard]] const StatusLine& statusLine() const { return *status_; }

signals:
  void openRequested(const QStringList& paths);
  void dropped(const QStringList& paths);
  void workedOn(const QString& project); // the file that edits go to now; empty: none yet

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool focusNextPrevChild(bool isNext) override;

private:
  // main_window_parts.cpp
  void makeParts();
  void makeFiles(PipelinePanel& pipeline);
  void makeEditing(PipelinePanel& pipeline, InspectorPanel& inspector);
  void makePanels(PipelinePanel& pipeline, InspectorPanel& inspector);
  void makeReview();
  void makePoints(PipelinePanel& pipeline);
  void makeViews();
  void makeEvaluation();
  void makePreview(PipelinePanel& pipeline);
  void joinEdits();
  void joinFiles();
  void joinReview();
  void joinPipeline();
  void joinPreview();
  void joinOrgans();
  void joinViews();
  [[nodiscard]] Reveal reveal();

  // menus.cpp
  void fillMenus();
  void fillToolBar();
  void showContextMenu(const QPoint& globalPosition);

  void makeCenter();
  void connectParts();
  void connectJobs();
  void connectMessages();
  void connectLog();
  void showNotice(const Notice& notice);
  void refreshDocks();
  void refreshTitle();
  void refreshCounts();
  void refreshHint();
  void refreshEmptiness();
  void refreshEnabled(); // of all parts
  void addLayoutAction();
  void resetLayout();
  void showRefusal(const QString& reason, Refusal where);
  void guarded(const std::function<void()>& act); // what it throws is in the banner

  QSettings& settings_;
  PlantDocument document_;
  JobQueue queue_;
  JobSlot jobs_{queue_, JobPriority::asked}; // of which the status line shows the progress
  std::unique_ptr<RecentFiles> recent_;
  std::unique_ptr<ActionSet> actions_;

  PlantView* view_;
  QSplitter* views_; // beside it there may be a second
  StartPage* start_;
  VertexPage* vertices_; // of a plant without positions
  QStackedWidget* center_;
  MessageBanner* banner_;
  QString refusal_; // the last one shown in the banner
  StatusLine* status_;

  std::unique_ptr<ViewSync> sync_;
  WindowParts parts_;
};

} // namespace espalier
