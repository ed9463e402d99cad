#pragma once

#include "core/project/piece_writer.h"
#include "core/project/project.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

class PlantDocument;

/// Writes every edit, undo and redo of a document into its project as it happens.
///
/// An edit is on the disk when PlantDocument::edit returns; a drag when it began and a moment after
/// each pause. What cannot be written is reported once, and tried again with the next edit: the
/// document goes on in memory, and nothing is lost as long as the program runs.
class ProjectRecorder : public QObject {
  Q_OBJECT

public:
  explicit ProjectRecorder(PlantDocument& document, QObject* parent = nullptr);

  /// A text that projects keep beside the plant, under this name; empty: nothing to keep. It is
  /// asked for when there is a pause.
  void keep(const std::string& name, std::function<std::string()> text);
  /// A text may have changed.
  void noteChange();
  /// Writes a text that is kept at once, with all steps that wait.
  void writeNow(const std::string& name);

  /// Keeps `project` up to date from here on. pre: its history and texts are those now
  void start(std::unique_ptr<Project> project);
  /// Nothing but the history is in the project yet: the rest follows when there is a pause.
  void writeRest();
  /// A scan that the plant has from the next step on: it is written with that, all at once.
  void growScan(const GrownReference& grown);
  /// Bytes that are written in pieces, whenever there is a pause.
  void writeLater(const std::string& name, std::function<std::string()> bytes);
  /// Writes what waits, and lets go of the project.
  std::unique_ptr<Project> stop();

  [[nodiscard]] Project* project() const { return project_.get(); } // null: none
  [[nodiscard]] bool isBehind() const { return isBehind_; }         // the last try to write failed

  /// Writes what waits: the end of a drag, texts, a snapshot. Contracted points, which are many,
  /// follow in pieces.
  void flush();

signals:
  void failed(const QString& message);
  void behindChanged();
  void projectChanged(); // another, or none

private:
  void follow();
  /// How many steps of the project, from the first on, are those of the document.
  [[nodiscard]] std::size_t keptSteps() const;
  void setBehind(bool isBehind);
  void save();
  void saveTexts();
  void saveText(const std::string& name); // if it is kept
  void writePiece();                      // throws
  void goOn();

  PlantDocument& document_;
  std::unique_ptr<Project> project_;
  std::vector<StepId> saved_; // the steps in the project
  int savedPosition_ = 0;
  std::map<std::string, std::function<std::string()>> texts_; // by name
  std::map<std::string, std::string> savedTexts_;             // likewise: those in the project
  std::optional<GrownReference> grown_;                       // that is not in the project yet
  bool isBehind_ = false;
  bool hasNewContracted_ = false;
  struct Later {
    std::string name;
    std::function<std::string()> bytes;
  };
  std::deque<Later> later_;
  std::optional<PieceWriter> writer_; // of what is being written in pieces
  QTimer pause_;
  QTimer piece_;
};

/// A project of the history and MTG of a document as it is now, in place of any file of this name.
/// See ProjectRecorder::writeRest(); the reference to the scan is for the caller to add.
/// @throws Error as Project::create
[[nodiscard]] std::unique_ptr<Project> makeProject(const PlantDocument& document,
                                                   const std::filesystem::path& path);

} // namespace espalier
