#pragma once

#include "app/window/files/load_project.h"
#include "app/window/files/sessions.h"
#include "app/window/frame/window_part.h"
#include "ui/document/project_recorder.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QSettings;
class QWidget;

namespace espalier {

class JobSlot;
class PlantDocument;
class RecentFiles;

/// A scan that was joined with another one, as its file is opened again.
struct GrownScan {
  std::unique_ptr<const Scan> scan;
  QString path;
  ScanReference reference;
};

/// Projects: opening and naming them, and the sessions that keep work which has no name yet.
///
/// A document is in a project from its first edit on: in one with a name, or in a session, which is
/// made a moment after a plant is opened, so that no edit waits for it. A session is removed once
/// nothing in it is unsaved; else the next start offers it.
class ProjectFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobSlot& jobs;
    RecentFiles& recent;
    QSettings& settings;
    QWidget& window;
  };
  explicit ProjectFlow(const Parts& parts);
  void beginWork() override { offerSessions(); }
  void endWork() override;

  /// What every project that is to replace the document passes once it is read: the gate may ask,
  /// and calls `show` or not.
  using Gate = std::function<void(const std::function<void()>& show)>;
  void setGate(Gate gate) { gate_ = std::move(gate); }

  [[nodiscard]] bool isNamed() const; // the document is in a project with a name
  [[nodiscard]] bool isLoading() const { return isLoading_; } // the document is being filled
  /// Whether nothing is lost if the window closes now, without a question.
  [[nodiscard]] bool keepsWork();

  /// As a job, and through the gate. One that another window works on, or that may only be read, is
  /// not opened; a copy, or to look at it without editing, is offered.
  void open(const QString& path);
  void openCopy(const QString& path);     // without a name, so the file stays as it is
  void openReadOnly(const QString& path); // every edit is refused, in words
  /// Each returns whether the document is in a project with a name now.
  /// @throws Error why it cannot be written
  bool saveAs();
  void saveAs(const QString& path);
  /// Reports that all is saved, or why it is not. Returns which. pre: isNamed()
  bool confirmSaved();
  void compact();

  /// Keeps what a part wants kept beside the plant. What is thrown as an Error is reported.
  void keep(const WindowPart& part);
  /// Writes what is kept under a name at once, instead of when there is a pause.
  void writeNow(const std::string& name) { recorder_.writeNow(name); }

  /// Keeps the scan in the project itself, or no longer; as a job. It is not taken out of there
  /// unless its file is found.
  /// @throws Error if the document has no scan or no project with a name, or a job is running
  void keepScan(bool isKept);
  [[nodiscard]] bool isScanKept() const { return isScanKept_; }

  [[nodiscard]] QString author() const; // of the edits, as in the history

  /// States of the plant that were named, the oldest first.
  [[nodiscard]] const std::vector<PlantVersion>& versions() const { return versions_; }
  /// Keeps another one in the project.
  /// @throws Error if there is no project with a name, or it has a version of this name
  void addVersion(const PlantVersion& version);
  void removeVersion(const std::string& name); // likewise

  /// Lets go of the project: the document will hold another plant.
  void leave();
  /// The same, and empties the document.
  void clear();
  /// Takes a scan that lists the points of the open one first (PlantDocument::growScan), and brings
  /// the others in as one step named `text`, with which the project has the scan.
  /// @throws Error if nothing may be edited; nothing has changed
  void growScan(const QString& text, GrownScan grown);
  /// The scan of the document, for the project. None: it has none.
  void setScanReference(const std::optional<ScanReference>& scan);
  [[nodiscard]] const std::optional<ScanReference>& scanReference() const { return scan_; }

  [[nodiscard]] const Sessions& sessions() const { return sessions_; }
  /// The newest that waits; if a plant is open, the newest of its scan or structure, or else what
  /// the plant before it was left with.
  void offerSessions();

signals:
  void opened();    // where it is seen from is kept beside it
  void scanFound(); // of the project that is open
  void scanGrown();
  void sessionsChanged();
  void chosen(const QString& path);       // a session to go on with
  void workedOn(const QString& project);  // the file that edits go to now; empty: none yet
  void authorChosen(const QString& name); // of whom further steps are to be recorded

private:
  enum class As : std::uint8_t { itself, copy, readOnly };
  void load(const QString& path, As as);
  void show(LoadedProject loaded, As as);
  void showBeside(const Project& project, QStringList& notes);
  void writeRest(); // of what a new project keeps
  void take(std::unique_ptr<Project> project);
  /// Whether the plant, with no edit since it was saved, holds what its file cannot: a review.
  [[nodiscard]] bool holdsMoreThanItsFile() const;
  void release(bool isSessionKept);
  void startSession();
  void makeSession(); // throws
  void prepareSession();
  void noteFile();
  [[nodiscard]] Project& named() const; // throws if there is none
  void takeIntoNew(Project& project) const;
  bool guarded(const std::function<void()>& act); // whether it went well
  void askForScan();
  void finishKeeping();
  void reportFailure(const QString& message);
  [[nodiscard]] bool isOfThePlant(const Session& session) const;
  /// To what was left last, if it is kept, in one message with what else is to be said.
  void offerToGoBack(const std::optional<Notice>& beside);
  [[nodiscard]] QString otherAuthor() const;
  [[nodiscard]] std::optional<Notice> authorNotice();

  Parts parts_;
  Sessions sessions_;
  ProjectRecorder recorder_;
  Gate gate_ = [](const std::function<void()>& show) { show(); };
  std::vector<Kept> beside_;
  std::vector<PlantVersion> versions_;
  QTimer prepare_;
  QString left_; // the session that was left last with work in it, until it is offered
  std::optional<ScanReference> scan_;
  ReadOptions reading_;     // of the scan of the project that was opened
  bool isScanKept_ = false; // in the project, or to be kept in the next one
  bool isKeeping_ = false;  // a job writes it
  bool isLoading_ = false;
  bool hasFailed_ = false; // no session could be made: reported once
};

} // namespace espalier
