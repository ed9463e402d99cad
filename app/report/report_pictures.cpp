#include "app/report/report_pictures.h"

#include "app/report/comparison_colors.h"
#include "core/base/error.h"
#include "core/evaluate/registration/registration.h"
#include "core/graph/turn_upright.h"
#include "ui/view/overlay.h"
#include "ui/view/picture.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

constexpr double pixelRatio = 2; // for paper and for screens that have it
constexpr int longSide = 1400;   // [pixels]
constexpr QSize errorSize(800, 600);

/// Width over height that suits a plant from front and side alike.
double aspectOf(const Scene& scene) {
  const Eigen::Vector3d sides = scene.bounds().sizes();
  const auto up = static_cast<int>(scene.up);
  const double height = sides[up];
  const double width = std::max(sides[(up + 1) % 3], sides[(up + 2) % 3]);
  return height > 0 ? std::clamp(width / height, 0.6, 1.5) : 1.5;
}

QSize sizeOf(double aspect) {
  return aspect > 1 ? QSize(longSide, static_cast<int>(std::lround(longSide / aspect)))
                    : QSize(static_cast<int>(std::lround(longSide * aspect)), longSide);
}

/// What has to be seen of an error: its edges, and where the reference attaches it.
std::vector<Eigen::Vector3d> placesOf(const ReportData& data, const DifferingPart& part) {
  const Skeleton& skeleton = part.kind == Difference::missed ? data.reference : data.result;
  std::vector<Eigen::Vector3d> places = {part.at};
  for (const NodeId id : part.nodes) {
    places.push_back(skeleton[id].position);
    if (const auto& parent = skeleton[id].parent) places.push_back(skeleton[*parent].position);
  }
  if (part.kind == Difference::wronglyAttached && part.host) places.push_back(part.place);
  for (Eigen::Vector3d& place : places)
    place = data.toScan * place;
  return places;
}

/// About the places, with what is around them to know them by; not smaller than `least`.
Eigen::AlignedBox3d around(const std::vector<Eigen::Vector3d>& places, double least) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& place : places)
    box.extend(place);
  const double margin = std::max(0.2 * box.sizes().maxCoeff(), least);
  return {box.min().array() - margin, box.max().array() + margin};
}

/// Looks across the direction in which the places spread most, so that they lie along the screen.
double yawAcross(const std::vector<Eigen::Vector3d>& places, UpAxis up) {
  Eigen::Matrix2Xd level(2, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
    level.col(static_cast<Eigen::Index>(i)) = (turnUpright(up) * places[i]).head<2>();
  level.colwise() -= level.rowwise().mean().eval();
  const Eigen::Matrix2d spread = level * level.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(spread);
  Eigen::Vector2d right = solver.eigenvectors().col(1);
  if (right.x() < 0) right = -right; // from the front rather than from behind
  return std::atan2(right.y(), right.x());
}

/// What is missed, with the nodes that it is attached to.
Skeleton missedOf(const Skeleton& reference, const std::vector<Difference>& kinds) {
  Skeleton missed;
  for (const NodeId id : reference.ids()) {
    const Node& node = reference[id];
    if (kinds[static_cast<std::size_t>(id)] != Difference::missed || !node.parent) continue;
    const NodeId foot = missed.add({.position = reference[*node.parent].position});
    missed.add({.position = node.position, .parent = foot, .edge = node.edge});
  }
  return missed;
}

bool hasRadii(const Skeleton& skeleton) {
  return std::ranges::any_of(skeleton.ids(), [&](NodeId id) { return skeleton[id].radius > 0; });
}

} // namespace

PictureSession::PictureSession(const ReportData& data, UpAxis up, QString unit)
    : unit_(std::move(unit)) {
  for (Scene* scene : {&both_, &result_, &reference_, &scan_})
    scene->setUp(up);
  const Skeleton result = moved(data.result, data.toScan);
  const Skeleton reference = moved(data.reference, data.toScan);
  const Skeleton missed = missedOf(reference, data.differences.ofReference);
  both_.setSkeleton(result);
  both_.setReference(missed);
  both_.setNodeColors(comparisonColors(data.differences.ofResult));
  both_.setReferenceColors(
      comparisonColors(std::vector<Difference>(missed.size(), Difference::missed)));
  result_.setSkeleton(result);
  result_.showRadii = hasRadii(result);
  reference_.setSkeleton(reference);
  reference_.showRadii = hasRadii(reference);
  if (data.scan) scan_.setCloud(data.scan);
  addWholes(data.scan != nullptr);
  addErrors(data);
}

PictureSession::PictureSession(const Skeleton& plant, std::shared_ptr<const PointCloud> scan,
                               UpAxis up, QString unit)
    : unit_(std::move(unit)) {
  for (Scene* scene : {&both_, &scan_})
    scene->setUp(up);
  both_.setSkeleton(plant);
  both_.showRadii = hasRadii(plant);
  const double aspect = aspectOf(both_);
  const QSize size = sizeOf(aspect);
  const Camera front = cameraFrom(StandardView::front, aspect);
  shots_.push_back({&both_, front, size, &ReportPictures::front});
  shots_.push_back({&both_, cameraFrom(StandardView::right, aspect), size, &ReportPictures::side});
  if (!scan) return;
  scan_.setCloud(std::move(scan));
  // A structure may be in another frame than its scan.
  const bool isThere = scan_.bounds().intersects(both_.bounds());
  const Camera ofScan = isThere ? front : cameraFrom(StandardView::front, aspect, scan_);
  shots_.push_back({&scan_, ofScan, size, &ReportPictures::scan});
}

Camera PictureSession::cameraFrom(StandardView view, double aspect) const {
  return cameraFrom(view, aspect, both_);
}

Camera PictureSession::cameraFrom(StandardView view, double aspect, const Scene& scene) const {
  Camera camera{.projection = Projection::parallel, .upAxis = both_.up};
  camera.face(view);
  camera.frame(scene.outline(), aspect);
  return camera;
}

void PictureSession::addWholes(bool hasScan) {
  const double aspect = aspectOf(both_);
  const QSize size = sizeOf(aspect);
  const Camera front = cameraFrom(StandardView::front, aspect);
  shots_.push_back({&both_, front, size, &ReportPictures::front});
  shots_.push_back({&both_, cameraFrom(StandardView::right, aspect), size, &ReportPictures::side});
  shots_.push_back({&result_, front, size, &ReportPictures::result});
  shots_.push_back({&reference_, front, size, &ReportPictures::reference});
  if (hasScan) shots_.push_back({&scan_, front, size, &ReportPictures::scan});
}

void PictureSession::addErrors(const ReportData& data) {
  const double least = 0.02 * both_.bounds().sizes().maxCoeff();
  for (const std::size_t i : shownErrors(data)) {
    const DifferingPart& part = data.differences.parts[i];
    const std::vector<Eigen::Vector3d> places = placesOf(data, part);
    const Eigen::AlignedBox3d box = around(places, least);
    Camera camera{.projection = Projection::parallel, .upAxis = both_.up};
    camera.yaw = yawAcross(places, both_.up);
    camera.frame(box, static_cast<double>(errorSize.width()) / errorSize.height());
    Shot shot{&both_, camera, errorSize, nullptr, box};
    shot.marks.push_back({data.toScan * part.at, false});
    if (part.kind == Difference::wronglyAttached && part.host)
      shot.marks.push_back({data.toScan * part.place, true});
    shots_.push_back(std::move(shot));
  }
}

QImage PictureSession::draw(const Shot& shot) const {
  Overlay overlay;
  overlay.unit = unit_;
  overlay.hasLegends = false; // the report has one for all
  Scene scene = *shot.scene;
  scene.clip.box = shot.box;
  QImage image = picture(scene, shot.camera, overlay, shot.size, pixelRatio);
  const QSizeF size = QSizeF(shot.size) / pixelRatio;
  const ScreenMap screen(shot.camera, {size.width(), size.height()});
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(pixelRatio, pixelRatio);
  for (const Mark& mark : shot.marks) {
    const auto at = screen.project(mark.place);
    if (!at) continue;
    painter.setPen(
        QPen(QColor(0x16, 0x18, 0x1a), 1.5, mark.isDashed ? Qt::DashLine : Qt::SolidLine));
    painter.drawEllipse(QPointF(at->pixel.x(), at->pixel.y()), 11, 11);
  }
  return image;
}

bool PictureSession::drawNext() {
  if (next_ == shots_.size()) return false;
  const Shot& shot = shots_[next_++];
  try {
    QImage image = draw(shot);
    if (shot.place != nullptr)
      pictures_.*shot.place = std::move(image);
    else
      pictures_.errors.push_back(std::move(image));
  } catch (const Error& error) {
    pictures_ = {};
    pictures_.problem = QString::fromUtf8(error.what());
    next_ = shots_.size();
  }
  return next_ < shots_.size();
}

double PictureSession::done() const {
  return static_cast<double>(next_) / static_cast<double>(shots_.size());
}

ReportPictures reportPictures(const ReportData& data, UpAxis up, const QString& unit) {
  PictureSession session(data, up, unit);
  while (session.drawNext()) {
  }
  return session.pictures();
}

} // namespace espalier
