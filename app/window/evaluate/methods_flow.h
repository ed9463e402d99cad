#pragma once

#include "app/window/evaluate/methods_text.h"
#include "app/window/frame/panel_dock.h"
#include "core/evaluate/evaluation.h"
#include "ui/jobs/job_slot.h"
#include "ui/panels/methods_panel.h"

#include <QObject>
#include <QStringList>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace espalier {

class PlantDocument;
class ReferenceFlow;

/// The methods dock: any number of structures against the reference, in one table with the plant.
///
/// Files are read again whenever they are compared: they may have been written anew. One that
/// cannot be read says so in its row and stops none of the others. A project keeps the table with
/// its numbers; of a file that is gone these stay, and its row says so.
class MethodsFlow : public QObject {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    JobQueue& queue;
    ReferenceFlow& reference;
    PanelDock::Parts window;
  };
  explicit MethodsFlow(const Parts& parts);

  [[nodiscard]] PanelDock& dock() { return *dock_; }
  void add(const QStringList& paths);
  /// How the plant is compared now: the others follow, each at its own place if it is laid.
  void setOptions(const EvaluationOptions& options);
  void setPlant(std::shared_ptr<const Evaluation> evaluation); // null: not compared yet
  void compareAll();                                           // anew

  /// The table as a project keeps it, and back.
  /// @throws Error if it is no such text; the table is empty then
  [[nodiscard]] std::string text() const;
  void show(const std::string& text);

signals:
  void noted(const QString& message);
  void changed(); // what a project keeps of it

private:
  struct Method {
    KeptMethod kept;
    QString error = {};
    bool isWaiting = true; // to be compared
  };
  [[nodiscard]] static Method methodOf(const KeptMethod& kept);
  void choose();
  void remove(const std::vector<int>& rows);
  void startNext();
  void finish(const std::function<void(Method&)>& note); // of the one that is compared now
  void list();
  void copy();

  Parts parts_;
  MethodsPanel* panel_;
  PanelDock* dock_;
  JobSlot job_{parts_.queue, JobPriority::asked};
  std::vector<Method> methods_;
  std::shared_ptr<const Evaluation> plant_;
  QString running_; // the path of the one that is compared now
  EvaluationOptions options_;
};

} // namespace espalier
