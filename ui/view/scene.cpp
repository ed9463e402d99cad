#include "ui/view/scene.h"

#include "core/cloud/far_points.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace espalier {

namespace {

double spacingOf(const Eigen::Matrix3Xf& points, const PointHierarchy& boxes) {
  constexpr Eigen::Index sample = 300;
  std::vector<float> distances;
  for (Eigen::Index i = 0; i < points.cols(); i += 1 + points.cols() / sample) {
    const float distance = boxes.distance(points, points.col(i), 0);
    if (std::isfinite(distance)) distances.push_back(distance);
  }
  if (distances.empty()) return 0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

} // namespace

void DrawnPoints::set(std::shared_ptr<const Eigen::Matrix3Xf> replacement) {
  if (replacement == positions) return;
  positions = std::move(replacement);
  ++revision;
}

void PointLayer::set(std::shared_ptr<const Eigen::Matrix3Xf> replacement) {
  DrawnPoints::set(std::move(replacement));
  boxes = positions ? PointHierarchy(*positions) : PointHierarchy();
  spacing = positions ? spacingOf(*positions, boxes) : 0;
}

void Scene::setCloud(std::shared_ptr<const PointCloud> replacement) {
  cloud = std::move(replacement);
  leftOut = {};
  measurePlant();
  pointStates.reset(); // they were those of other points
  pointValues.reset();
  // Shares the ownership of the cloud: its positions are not copied.
  points.set(cloud ? std::shared_ptr<const Eigen::Matrix3Xf>(cloud, &cloud->positions()) : nullptr);
  setContracted(contracted.positions);
  setPointColor(pointColor);
  skeleton.moveOrigin(origin());
  reference.moveOrigin(origin());
  for (const Side side : {Side::left, Side::right})
    setOther(side, std::nullopt); // it was of other points
}

void Scene::setLeftOut(const PointSet& aside) {
  if (aside == leftOut) return;
  leftOut = aside;
  measurePlant();
  const std::optional<ValueRange> seen = seenRange; // still seen, but for a few points
  setPointColor(pointColor);
  seenRange = seen;
}

void Scene::setContracted(std::shared_ptr<const Eigen::Matrix3Xf> positions) {
  contracted.set(std::move(positions));
  const bool wereSome = std::exchange(areSomeAtRest, false);
  if (contracted.size() > 0 && contracted.size() == points.size())
    for (Eigen::Index i = 0; i < contracted.size() && !areSomeAtRest; ++i)
      areSomeAtRest = isContractedAtRest(i);
  if (wereSome || areSomeAtRest) ++colorRevision;
}

void Scene::measurePlant() {
  plantBox = cloud && (!leftOut.isEmpty() || !farPoints(*cloud).empty())
                 ? plantBounds(*cloud, leftOut)
                 : Eigen::AlignedBox3d();
}

void Scene::setSkeleton(const Skeleton& replacement) {
  Eigen::Vector3d about = origin();
  if (points.size() == 0 && !replacement.isEmpty())
    about = replacement[replacement.ids().front()].position;
  skeleton.rebuild(replacement, about);
  reference.moveOrigin(about);
}

void Scene::setReference(const Skeleton& replacement) {
  if (points.size() == 0 && skeleton.bounds().isEmpty() && !replacement.isEmpty())
    skeleton.moveOrigin(replacement[replacement.ids().front()].position);
  reference.rebuild(replacement, origin());
}

void Scene::setOther(Side side, const std::optional<PlantState>& state) {
  OtherState& shown = other(side);
  shown.isShown = state.has_value();
  shown.name = state ? state->name : QString();
  shown.replacesPoints = state && state->replacesPoints;
  shown.within = state ? state->within : std::nullopt;
  shown.scanned = state ? state->scanned : nullptr;
  shown.points = state ? state->points : std::vector<Eigen::Index>();
  const auto travelled = state ? state->contracted : nullptr;
  if (travelled != shown.contracted.positions)
    shown.boxes = travelled ? PointHierarchy(*travelled) : PointHierarchy();
  shown.contracted.set(travelled);
  shown.skeleton.rebuild(state ? state->skeleton : Skeleton(), origin());
  if (state) shown.skeleton.setColors(state->colors);
  recolorNodes(shown); // no others: the user waits for this after each turn of a knob
}

bool Scene::showsPlant(const Eigen::Vector3d& place, double across, double divider) const {
  const OtherState& shown = other(across < divider ? Side::left : Side::right);
  return !shown.isShown || (shown.within && !shown.within->contains(place));
}

bool Scene::showsScanned(const Eigen::Vector3d& place, double across, double divider) const {
  const OtherState& shown = other(across < divider ? Side::left : Side::right);
  return !shown.replacesPoints || showsPlant(place, across, divider);
}

void Scene::setMovedScan(const std::optional<ShownScan>& scan) {
  const auto other = scan ? scan->cloud : nullptr;
  const bool isAnother = other != moved.shown.cloud;
  moved.shown = scan.value_or(ShownScan());
  ++moved.colorRevision;
  if (!isAnother) return;
  moved.set(other ? std::shared_ptr<const Eigen::Matrix3Xf>(other, &other->positions()) : nullptr);
  moved.boxes = other ? PointHierarchy(other->positions()) : PointHierarchy();
  moved.box = other ? plantBounds(*other) : Eigen::AlignedBox3d();
}

Eigen::Isometry3d Scene::movedPlacement() const {
  return Eigen::Translation3d(-origin()) * moved.shown.motion *
         Eigen::Translation3d(moved.shown.cloud->origin());
}

void Scene::setPointColor(PointColor color) {
  pointColor = color;
  seenRange.reset();
  colorLegend = cloud ? espalier::pointLegend(*cloud, color, up, leftOut) : std::nullopt;
  ++colorRevision;
}

void Scene::setSeenRange(std::optional<ValueRange> range) {
  seenRange = range;
  ++colorRevision;
}

void Scene::setPointStates(std::shared_ptr<const std::vector<PointState>> states) {
  pointStates = std::move(states);
  ++colorRevision;
  ++stateRevision;
}

void Scene::setPointValues(std::optional<PointValues> values) {
  pointValues = std::move(values);
  ++colorRevision;
}

void Scene::setNodeColors(std::optional<NodeColors> colors) {
  skeleton.setColors(std::move(colors));
  recolorNodes();
}

void Scene::setReferenceColors(std::optional<NodeColors> colors) {
  reference.setColors(std::move(colors));
  recolorNodes();
}

void Scene::setColorScales(const ColorScales& scales) {
  colorScales = scales;
  ++colorRevision;
  recolorNodes();
}

void Scene::setDark(bool isDark) {
  dark = isDark;
  ++colorRevision;
  recolorNodes();
}

void Scene::setUp(UpAxis axis) {
  up = axis;
  colorScales.ranges.erase(QStringLiteral("color_height")); // of other heights
  setPointColor(pointColor);
}

void Scene::setFocus(std::optional<Focus> replacement) {
  skeleton.setWhole(replacement ? replacement->branch : std::vector<NodeId>());
  focus = std::move(replacement);
}

FocusDepths Scene::focusDepths(const Camera& camera) const {
  return focus ? FocusDepths(*focus, focusFade, camera) : FocusDepths();
}

void Scene::recolorNodes() {
  const std::optional<Legend> legend = nodeLegend();
  skeleton.setColorMap(legend ? std::optional(LegendColors(*legend, dark)) : std::nullopt);
  const std::optional<Legend> other = referenceLegend();
  reference.setColorMap(other ? std::optional(LegendColors(*other, dark)) : std::nullopt);
  for (OtherState& shown : others)
    recolorNodes(shown);
}

void Scene::recolorNodes(OtherState& shown) const {
  const std::optional<Legend> legend = legendOf(shown);
  shown.skeleton.setColorMap(legend ? std::optional(LegendColors(*legend, dark)) : std::nullopt);
}

std::optional<Legend> Scene::pointLegend() const {
  if (pointValues) return colorScales.ofPoints(pointValues->legend);
  if (!colorLegend) return std::nullopt;
  Legend legend = *colorLegend;
  if (seenRange) std::tie(legend.from, legend.to) = std::pair(seenRange->from, seenRange->to);
  return colorScales.ofPoints(legend);
}

std::optional<Legend> Scene::movedLegend() const {
  const std::optional<PointValues>& values = moved.shown.values;
  return values ? std::optional(colorScales.ofPoints(values->legend)) : std::nullopt;
}

std::optional<Legend> Scene::nodeLegend() const {
  const Legend* given = skeleton.legend();
  return given != nullptr ? std::optional(colorScales.ofNodes(*given)) : std::nullopt;
}

std::optional<Legend> Scene::referenceLegend() const {
  const Legend* given = reference.legend();
  return given != nullptr ? std::optional(colorScales.ofNodes(*given)) : std::nullopt;
}

std::optional<Legend> Scene::legendOf(const OtherState& other) const {
  const Legend* given = other.skeleton.legend();
  return given != nullptr ? std::optional(colorScales.ofNodes(*given)) : std::nullopt;
}

ClipVolume Scene::clipVolume(const Camera& camera) const {
  return {clip, bounds(), origin(), camera};
}

DepthRange Scene::depths(const Camera& camera) const {
  constexpr double deepest = 100; // times how far off the focus is
  const DepthRange all = camera.depthsOf(boundsWithin({}));
  return all.farthest <= deepest * camera.distance ? all : camera.depthsOf(bounds());
}

Eigen::Vector3d Scene::origin() const {
  return cloud && !cloud->isEmpty() ? cloud->origin() : skeleton.origin();
}

Eigen::AlignedBox3d Scene::bounds() const {
  return boundsWithin(plantBox);
}

/// Of points only what lies in the box, unless that is empty.
Eigen::AlignedBox3d Scene::boundsWithin(const Eigen::AlignedBox3d& within) const {
  Eigen::AlignedBox3d box = skeleton.bounds().merged(reference.bounds());
  for (const PointLayer* layer : {&points, &contracted}) {
    const Eigen::AlignedBox3f local = layer->boxes.bounds();
    if (local.isEmpty()) continue;
    Eigen::AlignedBox3d ofLayer(local.min().cast<double>() + origin(),
                                local.max().cast<double>() + origin());
    if (!within.isEmpty()) ofLayer = ofLayer.intersection(within);
    if (!ofLayer.isEmpty()) box.extend(ofLayer);
  }
  if (moved.isShown()) {
    box.extend(moved.box.transformed(moved.shown.motion));
  }
  return box;
}

std::vector<Eigen::Vector3d> Scene::outline() const {
  constexpr Eigen::Index sample = 5000; // points of a layer
  std::vector<Eigen::Vector3d> places;
  for (const SkeletonGlyphs* glyphs : {&skeleton, &reference})
    for (std::size_t slot = 0; slot < glyphs->nodes().size(); ++slot)
      if (glyphs->nodes()[slot].shape != NodeShape::none) places.push_back(glyphs->position(slot));
  for (const PointLayer* layer : {&points, &contracted}) {
    const bool areAll = pointStates == nullptr || layer->size() != points.size();
    const Eigen::Index hidden =
        areAll ? 0
               : static_cast<Eigen::Index>(std::ranges::count(*pointStates, PointState::hidden));
    const Eigen::Index each = 1 + (layer->size() - hidden) / sample;
    Eigen::Index shown = 0;
    for (Eigen::Index i = 0; i < layer->size(); i += areAll ? each : 1) {
      if (!areAll && (!isPointShown(i) || shown++ % each != 0)) continue;
      const Eigen::Vector3d place = layer->positions->col(i).cast<double>() + origin();
      if (plantBox.isEmpty() || plantBox.contains(place)) places.push_back(place);
    }
  }
  if (moved.isShown())
    for (Eigen::Index i = 0; i < moved.size(); i += 1 + moved.size() / sample)
      places.emplace_back(moved.shown.motion * moved.shown.cloud->position(i));
  return places;
}

} // namespace espalier
