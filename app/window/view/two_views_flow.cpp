#include "app/window/view/two_views_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "app/window/view/empty_view.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QActionGroup>
#include <QScopedValueRollback>
#include <QSettings>
#include <QSplitter>

#include <numbers>
#include <optional>
#include <utility>

namespace espalier {
namespace {

constexpr double quarterTurn = std::numbers::pi / 2;

/// Does a view show all of the plant, or nearly so: the middle of each side of its box?
bool showsAll(const PlantView& view) {
  const Eigen::AlignedBox3d bounds = view.bounds();
  for (int side = 0; side < 6 && !bounds.isEmpty(); ++side) {
    Eigen::Vector3d middle = bounds.center();
    middle[side / 2] = (side % 2 == 0 ? bounds.min() : bounds.max())[side / 2];
    const std::optional<QPointF> at = view.project(middle);
    if (!at || !QRectF(view.rect()).contains(*at)) return false;
  }
  return true;
}

} // namespace

TwoViewsFlow::TwoViewsFlow(const Parts& parts) : parts_(parts), links_(new QActionGroup(this)) {
  addActions();
  connect(&parts_.view, &PlantView::cameraMoved, this, &TwoViewsFlow::linkFirst);
}

TwoViewsFlow::~TwoViewsFlow() {
  setTwo(false);
}

void TwoViewsFlow::addActions() {
  ActionSet& actions = parts_.actions;
  actions.beginSection(tr("View"));
  QAction* two = actions.add({.id = "two_views",
                              .text = tr("Two Views"),
                              .help = tr("Shows the plant from another side as well"),
                              .keys = Qt::Key_F12,
                              .isCheckable = true,
                              .menu = "view/more"},
                             {});
  connect(two, &QAction::toggled, this, [this](bool areTwo) {
    setTwo(areTwo);
    parts_.settings.setValue("view/two_views", areTwo);
  });
  const auto add = [&](Link link, const QString& id, const QString& text, const QString& help) {
    QAction* action = actions.add(
        {.id = id, .text = text, .help = help, .isCheckable = true, .menu = "view/second"},
        [this, link, id] {
          setLink(link);
          parts_.settings.setValue("view/link", id);
        });
    links_->addAction(action);
    if (parts_.settings.value("view/link", "link_side") == id) action->trigger();
  };
  add(Link::side, "link_side", tr("From the Side"),
      tr("The second view looks at a right angle to the first, and moves with it"));
  add(Link::same, "link_same", tr("Same Direction"),
      tr("The second view looks as the first, and moves with it"));
  add(Link::free, "link_free", tr("Not Linked"), tr("Each view is moved by itself"));
  add(Link::whole, "link_whole", tr("All of the Plant"),
      tr("The second view keeps all of the plant in sight; Look Closely in it shows a part of it "
         "in the first"));
  two->setChecked(parts_.settings.value("view/two_views", false).toBool());
}

void TwoViewsFlow::setTwo(bool areTwo) {
  if (areTwo == (second_ != nullptr)) return;
  if (!areTwo) {
    parts_.editing.removeView(*second_);
    delete std::exchange(second_, nullptr);
    return;
  }
  const bool hasShownAll = showsAll(parts_.view);
  second_ = new PlantView(parts_.view, &parts_.place);
  framed_.setEmpty();
  second_->setObjectName("second_view");
  second_->setAccessibleName(tr("Second view of the plant"));
  connect(second_, &PlantView::cameraMoved, this, [this](const Camera& camera) {
    if (isLinked()) follow(parts_.view, camera, link_ == Link::side ? -quarterTurn : 0);
  });
  sayWhyEmpty(*second_, parts_.actions);
  parts_.place.addWidget(second_);
  shareWidth();
  if (hasShownAll && !showsAll(parts_.view)) parts_.view.frameAll(); // it has half of its width
  parts_.editing.addView(*second_);
  linkFirst();
  if (link_ == Link::free) second_->look(StandardView::right);
}

/// What shows all of the plant needs less.
void TwoViewsFlow::shareWidth() {
  const int parts = link_ == Link::whole ? 3 : 2;
  const int second = parts_.place.width() / parts;
  parts_.place.setSizes({parts_.place.width() - second, second});
  parts_.place.refresh();
}

void TwoViewsFlow::setLink(Link link) {
  const bool hadWhole = std::exchange(link_, link) == Link::whole;
  if (second_ == nullptr) return;
  if (hadWhole != (link == Link::whole)) shareWidth();
  framed_.setEmpty();
  linkFirst();
}

void TwoViewsFlow::linkFirst() {
  if (second_ == nullptr || link_ == Link::free) return;
  if (link_ == Link::whole) {
    if (parts_.view.bounds().isApprox(framed_)) return; // where one has turned it to
    framed_ = parts_.view.bounds();
    return second_->frameAll();
  }
  follow(*second_, parts_.view.currentCamera(), link_ == Link::side ? quarterTurn : 0);
}

void TwoViewsFlow::follow(PlantView& follower, const Camera& camera, double turn) {
  if (isFollowing_) return;
  const QScopedValueRollback guard(isFollowing_, true);
  Camera turned = camera;
  if (turn != 0) turned.turn(turn, 0);
  follower.setCamera(turned);
}

} // namespace espalier
