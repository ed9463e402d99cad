#pragma once

#include "app/window/load_project.h"
#include "app/window/sessions.h"
#include "ui/document/project_recorder.h"

#include <QObject>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QSettings;
class QWidget;

namespace espalier {

class JobRunner;
class PlantDocument;
class RecentFiles;

/// Projects: opening and naming them, and the sessions that keep work which has no name yet.
///
/// A document is in a project from its first edit on: in one with a name, or in a session. A
/// session is removed once nothing in it is unsaved; else the next start offers it.
class ProjectFlow : public QObject {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobRunner& jobs;
    RecentFiles& recent;
    QSettings& settings;
    QWidget& window;
  };
  explicit ProjectFlow(const Parts& parts);
  ~ProjectFlow() override;

  /// What every project that is to replace the document passes once it is read: the gate may ask,
  /// and calls `show` or not.
  using Gate = std::function<void(const std::function<void()>& show)>;
  void setGate(Gate gate) { gate_ = std::move(gate); }

  [[nodiscard]] bool isNamed() const; // the document is in a project with a name
  /// Whether nothing is lost if the window closes now, without a question.
  [[nodiscard]] bool keepsWork();

  /// As a job, and through the gate. One that another window works on is not opened; a copy is
  /// offered.
  void open(const QString& path);
  void openCopy(const QString& path); // without a name, so the file stays as it is
  /// Each returns whether the document is in a project with a name now.
  /// @throws Error why it cannot be written
  bool saveAs();
  void saveAs(const QString& path);
  /// Tells that all is saved, or why it is not. Returns which. pre: isNamed()
  bool confirmSaved();
  void compact();

  /// Lets go of the project: the document will hold another plant.
  void leave();
  /// The scan of the document, for the project. None: it has none.
  void setScanReference(const std::optional<ScanReference>& scan);

  [[nodiscard]] const Sessions& sessions() const { return sessions_; }
  void offerSessions();

  /// What is to be told, with what can be done about it.
  struct Notice {
    QString text;
    bool isError = false;
    struct Action {
      QString text;
      std::function<void()> act;
    };
    std::vector<Action> actions; // at most two
  };

signals:
  void opened();
  void told(const espalier::ProjectFlow::Notice& notice);
  void sessionsChanged();
  void chosen(const QString& path); // a session to go on with

private:
  void load(const QString& path, Access access);
  void show(LoadedProject loaded, Access access);
  void take(std::unique_ptr<Project> project);
  void release(bool isSessionKept);
  void startSession();
  void noteFile();
  bool guarded(const std::function<void()>& act); // whether it went well
  void askForScan();
  void tellFailure(const QString& message);

  Parts parts_;
  Sessions sessions_;
  ProjectRecorder recorder_;
  Gate gate_ = [](const std::function<void()>& show) { show(); };
  std::optional<ScanReference> scan_;
  bool isLoading_ = false;
  bool hasFailed_ = false; // no session could be made: told once
};

} // namespace espalier
