#pragma once

#include "app/window/frame/window_part.h"

class QMenu;
class QWidget;

namespace espalier {

class ActionSet;
class PlantView;
struct SavedView;
class ShownFlow;
class ViewOptions;

/// Views with a name, to come back to: where from, what is clipped, what is hidden. The project
/// keeps them with how the plant is looked at.
class SavedViews : public WindowPart {
  Q_OBJECT

public:
  /// All must outlive it.
  struct Parts {
    PlantView& view;
    ViewOptions& options; // keeps them
    ShownFlow& shown;
    ActionSet& actions;
    QWidget& window;
  };
  explicit SavedViews(const Parts& parts);

private:
  /// Lists them, and what can be done with them, each time it is opened.
  void fill(QMenu& menu);
  void save(); // asks for a name; one that is taken is replaced
  void show(const SavedView& saved);
  void remove(const QString& name);

  PlantView& view_;
  ViewOptions& options_;
  ShownFlow& shown_;
  ActionSet& actions_;
  QWidget& window_;
};

} // namespace espalier
