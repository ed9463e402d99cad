#include "app/window/view/view_options.h"

#include "app/window/frame/action_set.h"
#include "app/window/frame/menu_title.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QActionGroup>
#include <QSettings>

#include <utility>

namespace espalier {

ViewOptions::ViewOptions(PlantView& view, ActionSet& actions, QSettings& settings)
    : view_(view), actions_(actions), settings_(settings), colors_(new QActionGroup(this)),
      nodeColors_(new QActionGroup(this)), pointMaps_(new QActionGroup(this)),
      nodeMaps_(new QActionGroup(this)), sizes_(new QActionGroup(this)),
      projections_(new QActionGroup(this)) {
  actions_.beginSection(tr("View"));
  addLayers();
  addColors();
  addNodeColors();
  addColorMaps();
  addColorRanges();
  addSizes();
  addProjections();
  addStandardViews();
  addMinimap();
  keepInProject({.name = "view",
                 .text = [this] { return text(); },
                 .show = [this](const std::string& text) { show(text); }});
  connect(&view_, &PlantView::clipChanged, this, &ViewOptions::keptChanged);
}

QList<QAction*> ViewOptions::nodeColors() const {
  return nodeColors_->actions();
}

void ViewOptions::setAvailable(bool hasIntensity, bool hasColor) {
  actions_["color_intensity"]->setVisible(hasIntensity);
  actions_["color_rgb"]->setVisible(hasColor);
  const QAction* chosen = colors_->checkedAction();
  if (chosen != nullptr && !chosen->isVisible()) actions_["color_height"]->trigger();
}

QList<std::pair<QString, QActionGroup*>> ViewOptions::choices() const {
  return {{"color", colors_},
          {"node_color", nodeColors_},
          {"point_map", pointMaps_},
          {"node_map", nodeMaps_},
          {"point_size", sizes_}};
}

std::string ViewOptions::text() const {
  ViewText shown{.camera = view_.camera(),
                 .layers = {},
                 .choices = {},
                 .ranges = view_.colorScales().ranges,
                 .clip = view_.clip(),
                 .depthFade = view_.depthFade(),
                 .saved = saved_};
  for (const QAction* layer : layers_)
    shown.layers[layer->objectName()] = layer->isChecked();
  for (const auto& [name, group] : choices())
    if (group->checkedAction() != nullptr)
      shown.choices[name] = group->checkedAction()->objectName();
  return textOf(shown);
}

void ViewOptions::show(const std::string& text) {
  if (text.empty()) return showRemembered();
  const ViewText shown = viewFrom(text);
  isRemembering_ = false;
  saved_ = shown.saved;
  for (QAction* layer : layers_)
    layer->setChecked(shown.layers.value(layer->objectName(), layer->isChecked()));
  setRanges(shown.ranges);
  view_.setDepthFade(shown.depthFade);
  view_.setClip(shown.clip);
  for (const auto& [name, group] : choices())
    for (QAction* choice : group->actions())
      if (choice->isVisible() && shown.choices.value(name) == choice->objectName())
        choice->trigger();
  for (QAction* projection : projections_->actions())
    projection->setChecked((projection->objectName() == "parallel") ==
                           (shown.camera.projection == Projection::parallel));
  view_.setCamera(shown.camera);
  isRemembering_ = true;
}

void ViewOptions::showRemembered() {
  saved_.clear();
  setRanges({});
  view_.setDepthFade(0);
  view_.setClip({});
  isRemembering_ = false;
  for (QAction* layer : layers_)
    layer->setChecked(
        ownLayers_.contains(layer) ||
        settings_.value("view/" + layer->objectName(), layer->objectName() != "true_radii")
            .toBool());
  const auto choose = [this](const QActionGroup& group, const QString& key,
                             const QString& standard) {
    const QString id = settings_.value(key, standard).toString();
    for (QAction* choice : group.actions())
      if (choice->objectName() == id && choice->isVisible()) choice->trigger();
  };
  choose(*colors_, "view/color", "color_height");
  choose(*nodeColors_, "view/node_color", "node_color_none");
  choose(*pointMaps_, "view/point_map", "point_map_viridis");
  choose(*nodeMaps_, "view/node_map", "node_map_viridis");
  choose(*sizes_, "view/point_size", "point_size_2");
  choose(*projections_, "view/projection", "perspective");
  view_.frameAll();
  isRemembering_ = true;
}

// What a project shows is that project's, and not how the next plant begins.
void ViewOptions::remember(const QString& key, const QVariant& value) {
  if (isRemembering_) settings_.setValue(key, value);
}

void ViewOptions::addLayers() {
  actions_.place("view/layers_title", [](QMenu& menu) { addTitle(menu, tr("Layers")); });
  enum class Begins : std::uint8_t { asLeft, shown };
  const auto add = [this](Layer layer, Command command, Begins begins = Begins::shown) {
    command.menu = "view/layers";
    command.isCheckable = true;
    const QString key = "view/" + command.id;
    QAction* action = actions_.add(command, {});
    if (begins == Begins::shown) ownLayers_.append(action);
    connect(action, &QAction::toggled, this, [this, layer, key, begins](bool isShown) {
      view_.setLayerVisible(layer, isShown);
      if (begins == Begins::asLeft) remember(key, isShown);
    });
    action->setChecked(true);
    if (begins == Begins::asLeft) action->setChecked(settings_.value(key, true).toBool());
    layers_.append(action);
  };
  add(Layer::points, {.id = "layer_points",
                      .text = tr("Points"),
                      .help = tr("Shows the scan"),
                      .keys = QKeySequence(Qt::CTRL | Qt::Key_1)});
  add(Layer::contracted,
      {.id = "layer_contracted",
       .text = tr("Contracted Points"),
       .help = tr("Shows where contraction has moved the points"),
       .keys = QKeySequence(Qt::CTRL | Qt::Key_2)},
      Begins::asLeft);
  add(Layer::skeleton, {.id = "layer_skeleton",
                        .text = tr("Skeleton"),
                        .help = tr("Shows nodes and edges"),
                        .keys = QKeySequence(Qt::CTRL | Qt::Key_3)});
  add(Layer::reference, {.id = "layer_reference",
                         .text = tr("Reference"),
                         .help = tr("Shows the structure that the skeleton is compared with"),
                         .keys = QKeySequence(Qt::CTRL | Qt::Key_6)});
  QAction* radii = actions_.add({.id = "true_radii",
                                 .text = tr("True Radii"),
                                 .help = tr("Draws edges as thick as the wood"),
                                 .keys = QKeySequence(Qt::CTRL | Qt::Key_4),
                                 .isCheckable = true,
                                 .menu = "view/layers"},
                                {});
  connect(radii, &QAction::toggled, this, [this](bool isOn) {
    view_.setShowRadii(isOn);
    remember("view/true_radii", isOn);
  });
  radii->setChecked(settings_.value("view/true_radii", false).toBool());
  layers_.append(radii);
}

QAction* ViewOptions::addChoice(QActionGroup* group, Command command, const QString& key,
                                const std::function<void()>& apply) {
  command.isCheckable = true;
  QAction* action = actions_.add(command, [this, apply, key, id = command.id] {
    apply();
    remember(key, id);
  });
  group->addAction(action);
  if (settings_.value(key) == command.id) action->trigger();
  return action;
}

void ViewOptions::addSizes() {
  for (const int pixels : {1, 2, 3, 4, 6, 8})
    addChoice(sizes_,
              {.id = QStringLiteral("point_size_%1").arg(pixels),
               .text = tr("%1 px").arg(pixels),
               .help = tr("Draws points of this size"),
               .menu = "view/sizes",
               .inPalette = tr("Point Size %1 px").arg(pixels)},
              QStringLiteral("view/point_size"), [this, pixels] { view_.setPointSize(pixels); });
  if (sizes_->checkedAction() == nullptr) actions_["point_size_2"]->trigger();
}

void ViewOptions::addProjections() {
  const auto add = [this](Projection projection, const Command& command) {
    addChoice(projections_, command, QStringLiteral("view/projection"),
              [this, projection] { view_.setProjection(projection); });
  };
  add(Projection::perspective, {.id = "perspective",
                                .text = tr("Perspective"),
                                .help = tr("Near things are larger"),
                                .menu = "view/projections"});
  add(Projection::parallel, {.id = "parallel",
                             .text = tr("Parallel"),
                             .help = tr("Equal lengths look equal"),
                             .menu = "view/projections"});
  if (projections_->checkedAction() == nullptr) actions_["perspective"]->trigger();
  QAction* stereo =
      actions_.add({.id = "stereo",
                    .text = tr("Red-Cyan Stereo"),
                    .help = tr("Draws the plant for each eye, for glasses of red and cyan"),
                    .isCheckable = true,
                    .menu = "view/projections"},
                   {});
  connect(stereo, &QAction::toggled, this, [this](bool isStereo) { view_.setStereo(isStereo); });
}

void ViewOptions::addMinimap() {
  QAction* map =
      actions_.add({.id = "minimap",
                    .text = tr("Minimap"),
                    .help = tr("Shows all of the plant in a corner, to move about in it"),
                    .keys = QKeySequence(Qt::CTRL | Qt::Key_M),
                    .isCheckable = true,
                    .menu = "view/more"},
                   {});
  connect(map, &QAction::toggled, this, [this](bool isShown) {
    view_.setMinimapShown(isShown);
    settings_.setValue("view/minimap", isShown);
  });
  map->setChecked(settings_.value("view/minimap", true).toBool());
}

void ViewOptions::addStandardViews() {
  const auto add = [this](StandardView view, const QString& id, const QString& text, Qt::Key key) {
    QAction* action = actions_.add({.id = id,
                                    .text = text,
                                    .help = tr("Looks from there"),
                                    .keys = QKeySequence(Qt::KeypadModifier | key),
                                    .menu = "view/directions"},
                                   [this, view] { view_.look(view); });
    action->setShortcuts({action->shortcut(), QKeySequence(Qt::ALT | key)}); // without a keypad
  };
  // As the number block lies, as in CloudCompare. The digits in the top row select.
  add(StandardView::front, "view_front", tr("Front"), Qt::Key_5);
  add(StandardView::back, "view_back", tr("Back"), Qt::Key_0);
  add(StandardView::left, "view_left", tr("Left"), Qt::Key_4);
  add(StandardView::right, "view_right", tr("Right"), Qt::Key_6);
  add(StandardView::top, "view_top", tr("Top"), Qt::Key_8);
  add(StandardView::bottom, "view_bottom", tr("Bottom"), Qt::Key_2);
  add(StandardView::isometric, "view_isometric", tr("Isometric"), Qt::Key_7);
  actions_.add({.id = "frame_all",
                .text = tr("Frame All"),
                .help = tr("The whole plant fills the view"),
                .icon = "frame_all",
                .keys = Qt::Key_Home,
                .menu = "view/frame_all"},
               [this] { view_.frameAll(); });
}

} // namespace espalier
