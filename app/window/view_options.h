#pragma once

#include <QList>
#include <QObject>

#include <functional>

class QAction;
class QActionGroup;
class QSettings;

namespace espalier {

class ActionSet;
struct Command;
class PlantView;

/// How the plant is drawn: layers, colors, sizes, projection, and where it is seen from. Remembered
/// in the settings.
class ViewOptions : public QObject {
  Q_OBJECT

public:
  ViewOptions(PlantView& view, ActionSet& actions, QSettings& settings, QObject* parent);

  [[nodiscard]] QList<QAction*> layers() const { return layers_; }
  [[nodiscard]] QList<QAction*> colors() const;
  [[nodiscard]] QList<QAction*> sizes() const;
  [[nodiscard]] QList<QAction*> projections() const;
  [[nodiscard]] QList<QAction*> standardViews() const { return standardViews_; }

  /// Offers only the colors that the points have.
  void setAvailable(bool hasIntensity, bool hasColor);

private:
  void addLayers();
  void addColors();
  void addSizes();
  void addProjections();
  void addStandardViews();
  QAction* addChoice(QActionGroup* group, const Command& command, const QString& key,
                     const std::function<void()>& apply);

  PlantView& view_;
  ActionSet& actions_;
  QSettings& settings_;
  QActionGroup* colors_;
  QActionGroup* sizes_;
  QActionGroup* projections_;
  QList<QAction*> layers_;
  QList<QAction*> standardViews_;
};

} // namespace espalier
