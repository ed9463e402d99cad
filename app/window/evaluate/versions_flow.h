#pragma once

#include "app/window/frame/window_part.h"
#include "core/skeleton/skeleton.h"

#include <QString>

#include <functional>
#include <vector>

class QMainWindow;
class QMenu;

namespace espalier {

class ActionSet;
class PlantDocument;
class ProjectFlow;
class ReferenceFlow;

/// States of the plant that were named, or that its history still has, and comparing with them.
class VersionsFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    ProjectFlow& projects;
    ReferenceFlow& reference;
    ActionSet& actions;
    QMainWindow& window;
  };
  explicit VersionsFlow(const Parts& parts);

private:
  /// A state that the plant can be compared with.
  struct Choice {
    QString name; // for people
    QString text; // of the list: with who made it, and when
    std::function<Skeleton()> skeleton;
  };
  void name();
  void compare();
  void remove(const QString& name);
  void fillRemoval(QMenu& menu);
  /// Those that were named, then the ends of days, each with the newest first, then what the work
  /// by hand began with.
  [[nodiscard]] std::vector<Choice> choices() const;
  [[nodiscard]] bool isNamed(const QString& name) const;

  Parts parts_;
};

} // namespace espalier
