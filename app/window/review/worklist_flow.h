#pragma once

#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"
#include "app/window/review/worklist_reading.h"
#include "ui/jobs/job_slot.h"

#include <QTimer>

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace espalier {

class PlantDocument;
class WorklistPanel;
struct ListedPlant;

/// The worklist: many plants in a panel, of which one after another is opened.
///
/// What is shown of each plant is read in the background, a file at a time, and again when the file
/// has changed: every two seconds, while the panel is shown, it is looked which have. The list that
/// was open last is there in the next session.
class WorklistFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobSlot& jobs; // opens files
    PanelDock::Parts window;
    std::function<void(const QString& file)> open; // a plant of its own; asks about unsaved work
    std::function<void(const QString& file)> compareWith; // loads the reference of the open plant
  };
  explicit WorklistFlow(const Parts& parts);
  void beginWork() override;

  /// Takes the plants of a folder or of a table for the worklist, and shows it.
  void list(const QString& place);

private:
  using Pair = std::pair<std::filesystem::path, std::filesystem::path>; // of projects, in order
  struct Compared {
    FileStamp first, second;
    std::optional<SealedAgreement> agreement;
  };
  void addActions();
  void chooseFolder();
  void chooseTable();
  void open(const QString& file);
  void openNext();
  void compareWithSecond();
  /// Surveys what was not read yet; true: it has to be waited for.
  /// @throws Error if there is no worklist, or it cannot be read
  [[nodiscard]] bool isBeingRead();
  void noteFailure(const QString& message); // of a plant of the list that was to be opened
  [[nodiscard]] QString openFile() const;   // of the plant that is open; empty: it has none

  void survey();
  void takeSurvey(SurveyedWorklist found);
  void readNext();
  [[nodiscard]] bool isProject(const std::filesystem::path& file) const;
  [[nodiscard]] bool startHash(); // of a scan that is needed; false: of none
  void takePlant(const std::filesystem::path& file, ReadPlant plant);
  [[nodiscard]] std::optional<Pair> nextToCompare() const;
  [[nodiscard]] const Compared* comparedOf(const Pair& pair) const; // null: not as they are now
  void compare(const Pair& pair);
  void show();
  [[nodiscard]] ListedPlant listed(WorklistRow row) const;

  Parts parts_;
  WorklistPanel* panel_ = nullptr;
  PanelDock* dock_ = nullptr;
  PictureCache pictures_;
  QString place_; // empty: there is none
  QString problem_;
  Worklist list_;
  FileStamps stamps_;
  KnownWorks known_;
  std::map<std::filesystem::path, QImage> faces_; // pictures, by file
  std::map<Pair, Compared> compared_;
  std::deque<std::filesystem::path> toRead_;                // projects first
  std::optional<std::deque<std::filesystem::path>> toHash_; // none: not known yet
  std::filesystem::path opening_;                           // by a job; empty: none of the list
  QTimer again_;                                            // to look for files that have changed
  QTimer later_;                                            // to show what was read
  JobSlot survey_{parts_.jobs.queue(), JobPriority::background};
  JobSlot read_{parts_.jobs.queue(), JobPriority::background};
};

} // namespace espalier
