#pragma once

#include "app/window/evaluate/reference_text.h"
#include "app/window/frame/window_part.h"
#include "core/project/project.h"

#include <Eigen/Geometry>
#include <QStringList>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QMainWindow;
class QSettings;

namespace espalier {

class ActionSet;
class JobSlot;
class PlantDocument;
class PlantView;

/// The reference: loading and removing it, its layer in the view, and its text in the project.
class ReferenceFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    JobSlot& jobs;
    ActionSet& actions;
    QSettings& settings;
    QMainWindow& window;
    std::function<std::optional<ScanReference>()> scan; // of the plant; none: it has none
  };
  explicit ReferenceFlow(Parts parts);

  /// Null: there is none.
  [[nodiscard]] const std::shared_ptr<const Skeleton>& skeleton() const { return skeleton_; }
  [[nodiscard]] QString name() const;                         // of its file, for people
  [[nodiscard]] bool isVersion() const { return isVersion_; } // a state of the plant itself
  [[nodiscard]] bool liesInPlace() const { return isVersion_ || isOfScan_; } // in one frame
  [[nodiscard]] QString key() const; // what it is known by, among all; empty: there is none
  [[nodiscard]] const Skeleton& laid() const { return laid_; } // as it is drawn, under its own ids

  /// Reads a structure, or the plant of a project, as a job.
  /// @throws Error if it is not one, or a job is running
  void load(const QString& path);
  /// Takes a state of the plant itself in place of a structure, which comes back when that is
  /// removed.
  /// @param name  of the state, for people
  /// @throws Error if nothing can be compared with it, or a job is running
  void takeVersion(Skeleton skeleton, const QString& name);
  /// Draws it moved, until another is loaded.
  void lay(const Eigen::Isometry3d& motion);

  /// Asks what a structure that is dropped on a plant is to be. False: it is to be opened.
  [[nodiscard]] bool takesDropped(const QStringList& paths);

signals:
  void changed();                               // another, or none
  void loaded();                                // by hand
  void openRequested(const QStringList& paths); // what was dropped

private:
  void addActions();
  void choose();
  /// The structure that lies beside the scan under its name; empty: none, or it is what is open.
  [[nodiscard]] QString beside() const;
  void refreshBeside();
  void show(const std::string& text);
  void remove();
  void set(Reference reference);
  void askAbout(const QStringList& paths);

  Parts parts_;
  std::shared_ptr<const Skeleton> skeleton_;
  Skeleton laid_;
  QString path_; // or the name of the version
  bool isVersion_ = false;
  bool isOfScan_ = false;
  std::vector<Reference> before_; // what a version stands in the place of: none, or one
  std::string text_;              // once made: projects ask for it often
};

} // namespace espalier
