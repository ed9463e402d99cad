#pragma once

#include "core/project/project.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <cstdint>
#include <memory>
#include <vector>

namespace espalier {

class PlantDocument;

/// Writes every edit, undo and redo of a document into its project as it happens.
///
/// An edit is on the disk when PlantDocument::edit returns; a drag when it began and a moment after
/// each pause. What cannot be written is told once, and tried again with the next edit: the
/// document goes on in memory, and nothing is lost as long as the program runs.
class ProjectRecorder : public QObject {
  Q_OBJECT

public:
  explicit ProjectRecorder(PlantDocument& document, QObject* parent = nullptr);

  /// Keeps `project` up to date from here on. pre: its history is that of the document now
  void start(std::unique_ptr<Project> project);
  /// Writes what waits, and lets go of the project.
  std::unique_ptr<Project> stop();

  [[nodiscard]] Project* project() const { return project_.get(); } // null: none
  [[nodiscard]] bool isBehind() const { return isBehind_; }         // the last try to write failed

  /// Writes what waits: the end of a drag, contracted points, a snapshot.
  void flush();

signals:
  void failed(const QString& message);

private:
  void follow();
  [[nodiscard]] std::vector<std::uint64_t> revisionsNow() const;
  void save(const std::vector<std::uint64_t>& revisions);

  PlantDocument& document_;
  std::unique_ptr<Project> project_;
  std::vector<std::uint64_t> saved_; // revisions of the steps in the project
  int savedPosition_ = 0;
  bool isBehind_ = false;
  bool hasNewContracted_ = false;
  QTimer pause_;
};

/// A project of the document as it is now, in place of any file of this name. What is no edit, as
/// the reference to the scan, is for the caller to add.
/// @throws Error as Project::create
[[nodiscard]] std::unique_ptr<Project> makeProject(const PlantDocument& document,
                                                   const std::filesystem::path& path);

} // namespace espalier
