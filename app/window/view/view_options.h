#pragma once

#include "app/window/frame/window_part.h"
#include "app/window/view/view_text.h"

#include <QList>

#include <functional>
#include <string>
#include <utility>
#include <vector>

class QAction;
class QActionGroup;
class QSettings;
class QVariant;

namespace espalier {

class ActionSet;
struct Command;
class PlantView;

/// How the plant is drawn: layers, colors, sizes, projection, and where it is seen from. Remembered
/// in the settings, but for layers without which a plant would be opened and not be seen.
class ViewOptions : public WindowPart {
  Q_OBJECT

public:
  ViewOptions(PlantView& view, ActionSet& actions, QSettings& settings);

  [[nodiscard]] QList<QAction*> nodeColors() const; // what they do: ValueColors

  /// What is shown and from where, as JSON, and back. An empty text: what the settings remember,
  /// and all of the plant. Showing a text changes no setting.
  /// @throws Error if it is no such text; nothing has changed then
  [[nodiscard]] std::string text() const;
  void show(const std::string& text);

  /// Kept in the text.
  [[nodiscard]] const std::vector<SavedView>& savedViews() const { return saved_; }
  void setSavedViews(std::vector<SavedView> views) { saved_ = std::move(views); }

  /// Offers only the colors that the points have.
  void setAvailable(bool hasIntensity, bool hasColor);

private:
  void showRemembered();
  void setRanges(const std::map<QString, ValueRange>& ranges);
  void remember(const QString& key, const QVariant& value);
  void addLayers();
  void addColors();
  void addNodeColors();
  void addColorMaps();
  void addColorRanges();
  void addSizes();
  void addProjections();
  void addStandardViews();
  void addMinimap();
  [[nodiscard]] QList<std::pair<QString, QActionGroup*>> choices() const; // by choiceNames()
  QAction* addChoice(QActionGroup* group, Command command, const QString& key,
                     const std::function<void()>& apply);

  PlantView& view_;
  ActionSet& actions_;
  QSettings& settings_;
  bool isRemembering_ = true;
  std::vector<SavedView> saved_;
  QActionGroup* colors_;
  QActionGroup* nodeColors_;
  QActionGroup* pointMaps_;
  QActionGroup* nodeMaps_;
  QActionGroup* sizes_;
  QActionGroup* projections_;
  QList<QAction*> layers_;
  QList<QAction*> ownLayers_; // of these, those that each plant begins with
};

} // namespace espalier
