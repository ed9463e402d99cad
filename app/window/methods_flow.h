#pragma once

#include "app/window/panel_dock.h"
#include "core/evaluate/evaluation.h"
#include "ui/jobs/job_runner.h"
#include "ui/panels/methods_panel.h"

#include <QObject>
#include <QStringList>

#include <memory>
#include <vector>

namespace espalier {

class PlantDocument;
class ReferenceFlow;

/// The methods dock: any number of structures against the reference, in one table with the plant.
///
/// Files are read again whenever they are compared: they may have been written anew. One that
/// cannot be read says so in its row and stops none of the others.
class MethodsFlow : public QObject {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    ReferenceFlow& reference;
    PanelDock::Parts window;
  };
  explicit MethodsFlow(const Parts& parts);

  [[nodiscard]] PanelDock& dock() { return *dock_; }
  void add(const QStringList& paths);
  /// How the plant is compared now: the others follow, each at its own place if it is laid.
  void setOptions(bool isLaid, double tolerance);
  void setPlant(std::shared_ptr<const Evaluation> evaluation); // null: not compared yet
  void compareAll();                                           // anew

signals:
  void noted(const QString& message);

private:
  struct Method {
    QString path;
    MethodRow row;
    bool isWaiting = true; // to be compared
  };
  void choose();
  void startNext();
  void list();
  void copy();

  Parts parts_;
  MethodsPanel* panel_;
  PanelDock* dock_;
  JobRunner job_;
  std::vector<Method> methods_;
  std::shared_ptr<const Evaluation> plant_;
  QString running_; // the path of the one that is compared now
  bool isLaid_ = true;
  double tolerance_ = 0; // [L]; 0: by the rule
};

} // namespace espalier
