#include "app/window/preview/sight_flow.h"

#include "app/window/edit/editing.h"
#include "app/window/frame/action_set.h"
#include "app/window/preview/preview_flow.h"
#include "ui/document/number_scale.h"
#include "ui/document/plant_document.h"
#include "ui/panels/pipeline_panel.h"
#include "ui/view/plant_view.h"

#include <QAction>

#include <utility>

namespace espalier {
namespace {

std::vector<Eigen::Vector3d> placesOf(const std::vector<Eigen::Index>& points,
                                      const PointCloud& cloud) {
  std::vector<Eigen::Vector3d> places;
  places.reserve(points.size());
  for (const Eigen::Index point : points)
    places.emplace_back(cloud.positions().col(point).cast<double>() + cloud.origin());
  return places;
}

QStringList linesOf(const MethodSight& sight, LengthUnit unit) {
  const QString points = sight.ball.size() == 1
                             ? SightFlow::tr("1 point")
                             : SightFlow::tr("%1 points").arg(formatCount(sight.ball.size()));
  QStringList lines = {
      sight.radius > 0
          ? SightFlow::tr("%1 within %2").arg(points, formatLength(sight.radius, unit, 3))
          : points,
      SightFlow::tr("Linearity %1 (1: along a line)").arg(numberText(sight.linearity, 2)),
      SightFlow::tr("Density %1 (0 thinnest, 1 densest)").arg(numberText(sight.density, 2))};
  if (sight.circle)
    lines.append(
        SightFlow::tr("Circle of radius %1").arg(formatLength(sight.circle->radius, unit, 3)));
  return lines;
}

ShownSight shownOf(const MethodSight& sight, const PointCloud& cloud, const Scan& scan,
                   LengthUnit unit) {
  ShownSight shown{.point = placesOf({sight.point}, cloud).front(),
                   .moved = sight.moved,
                   .neighbors = placesOf(sight.neighbors, cloud),
                   .ball = placesOf(sight.ball, cloud),
                   .direction = sight.direction,
                   .normal = sight.normal,
                   .reach = sight.radius > 0 ? sight.radius : 6 * scan.spacing(),
                   .circle = std::nullopt,
                   .cones = {},
                   .lines = linesOf(sight, unit)};
  if (sight.circle)
    shown.circle = {sight.circle->center, sight.circle->normal, sight.circle->radius};
  for (const SightCone& cone : sight.cones)
    shown.cones.push_back({cone.apex, cone.direction, cone.angle, cone.length});
  return shown;
}

} // namespace

SightFlow::SightFlow(const Parts& parts) : parts_(parts) {
  parts_.actions.beginSection(tr("Preview"));
  show_ = parts_.actions.add({.id = "method_sight",
                              .text = tr("What the Method Sees"),
                              .help = tr("Draws, at the point under the mouse, its neighbors, what "
                                         "its new place is from, directions and circles"),
                              .keys = QKeySequence(Qt::CTRL | Qt::Key_0),
                              .isCheckable = true,
                              .menu = "preview/points"},
                             {});
  connect(show_, &QAction::toggled, this, &SightFlow::turn);
  timer_.setSingleShot(true);
  timer_.setInterval(15); // [ms]
  connect(&timer_, &QTimer::timeout, this, &SightFlow::look);
  connect(&job_, &JobSlot::failed, this, &SightFlow::failed);
  connect(&parts_.preview, &PreviewFlow::changed, this, &SightFlow::prepare);
  connect(&parts_.pipeline, &PipelinePanel::changed, this, &SightFlow::prepare);
  connect(&parts_.document, &PlantDocument::contractedChanged, this, &SightFlow::prepare);
  connect(&parts_.document, &PlantDocument::scanChanged, this, [this] {
    sights_.reset();
    prepare();
  });
  connect(&parts_.editing, &Editing::pointed, this, [this] {
    if (sights_) timer_.start();
  });
}

void SightFlow::turn(bool isOn) {
  if (isOn) return prepare();
  job_.cancel();
  sights_.reset();
  shown_.reset();
  parts_.view.showSight(std::nullopt);
}

void SightFlow::prepare() {
  const Scan* scan = parts_.document.scan();
  if (!show_->isChecked() || scan == nullptr) return parts_.view.showSight(std::nullopt);
  const std::optional<Outcome>& preview = parts_.preview.shown();
  if (parts_.preview.isLive() && (!preview || preview->within)) return; // of all of it soon
  PipelineOptions options = preview ? preview->options : parts_.pipeline.options();
  options.leftOut = parts_.document.leftOut();
  const auto contracted = preview ? preview->contracted : parts_.document.contracted();
  if (!contracted) {
    show_->setChecked(false);
    emit noted(tr("Nothing is contracted yet: turn on Live Preview, or reconstruct"));
    return;
  }
  job_.start(
      [cloud = scan->cloud(), contracted, options,
       scale = parts_.document.scale()](const Progress& progress) {
        return std::make_shared<const MethodSights>(cloud, contracted, options, scale, progress);
      },
      [this](const std::shared_ptr<const MethodSights>& sights) {
        sights_ = sights;
        shown_.reset();
        look();
      });
}

/// The point of the scan that is drawn there: in a preview, where that contracts it.
Eigen::Index SightFlow::pointAt(const Eigen::Vector3f& place) const {
  const std::optional<Outcome>& preview = parts_.preview.shown();
  if (!parts_.editing.under().isOfOther || !preview || preview->within)
    return parts_.document.scan()->index().nearestOne(place)->index;
  Eigen::Index point = 0;
  (preview->contracted->colwise() - place).colwise().squaredNorm().minCoeff(&point);
  return point;
}

void SightFlow::look() {
  if (!sights_ || !show_->isChecked()) return;
  const std::optional<Eigen::Vector3d>& under = parts_.editing.under().point;
  if (!under) {
    shown_.reset();
    return parts_.view.showSight(ShownSight{.lines = {tr("Point at the plant")}});
  }
  const Scan& scan = *parts_.document.scan();
  const Eigen::Index point = pointAt((*under - scan.cloud()->origin()).cast<float>());
  if (shown_ == point) return;
  shown_ = point;
  parts_.view.showSight(shownOf(sights_->at(point, parts_.document.skeleton()), *scan.cloud(), scan,
                                parts_.document.unit()));
}

} // namespace espalier
