#include "app/window/view/value_colors.h"

#include "app/window/edit/organ_flow.h"
#include "app/window/frame/action_set.h"
#include "app/window/view/view_options.h"
#include "core/cloud/displacements.h"
#include "core/skeleton/node_values.h"
#include "ui/document/plant_document.h"
#include "ui/document/review_look.h"
#include "ui/view/plant_view.h"

#include <QAction>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace espalier {
namespace {

const QString byDistance = QStringLiteral("color_distance"); // ids of actions
const QString byDisplacement = QStringLiteral("color_displacement");
const QString byOrgan = QStringLiteral("color_organ");
constexpr float asUsual = std::numeric_limits<float>::quiet_NaN(); // drawn as usual

const std::map<QString, NodeValue>& valuesById() {
  static const std::map<QString, NodeValue> values = {
      {"node_color_distance", NodeValue::distance},
      {"node_color_order", NodeValue::order},
      {"node_color_radius", NodeValue::radius},
      {"node_color_radius_to_parent", NodeValue::radiusToParent},
      {"node_color_radius_spread", NodeValue::radiusSpread},
      {"node_color_confidence", NodeValue::confidence},
  };
  return values;
}

/// The value below which all but two in a hundred are; few stray ones do not take up the scale.
template <class Number> double nearlyLargest(std::vector<Number> numbers) {
  if (numbers.empty()) return 1;
  const auto at = numbers.begin() + static_cast<std::ptrdiff_t>(0.98 * double(numbers.size() - 1));
  std::nth_element(numbers.begin(), at, numbers.end());
  return *at > 0 ? double(*at) : 1;
}

NodeColors reviewColors(const Skeleton& skeleton, bool isDark) {
  NodeColors colors{
      .values = std::vector<float>(skeleton.idEnd(), asUsual),
      .legend = {.id = "node_color_review", .title = ValueColors::tr("Review"), .unit = {}}};
  for (const ReviewState state : {ReviewState::toDo, ReviewState::doubtful, ReviewState::reviewed})
    colors.legend.categories.push_back({titleOf(state), colorOf(state, isDark)});
  for (const NodeId id : skeleton.ids())
    colors.values[indexOf(id)] = static_cast<float>(skeleton[id].review.state);
  return colors;
}

} // namespace

ValueColors::ValueColors(const Parts& parts) : parts_(parts) {
  timer_.setSingleShot(true);
  timer_.setInterval(15); // [ms]: a drag of many edits is shown at once
  connect(&timer_, &QTimer::timeout, this, &ValueColors::show);
  for (const QAction* action : parts_.options.nodeColors())
    connect(action, &QAction::toggled, this, &ValueColors::choose);
  for (const QString& id : {byDistance, byDisplacement, byOrgan})
    connect(parts_.actions[id], &QAction::toggled, this, &ValueColors::choose);
  connect(parts_.actions[byOrgan], &QAction::triggered, this,
          [this] { parts_.organs.setWanted(pointColor_ == byOrgan); }); // once more
  connect(&parts_.organs, &OrganFlow::changed, &timer_, qOverload<>(&QTimer::start));
  connect(&parts_.distances, &ScanDistances::changed, &timer_, qOverload<>(&QTimer::start));
  PlantDocument& document = parts_.document;
  connect(&document, &PlantDocument::skeletonEdited, &timer_, qOverload<>(&QTimer::start));
  for (auto signal : {&PlantDocument::skeletonReplaced, &PlantDocument::scanChanged,
                      &PlantDocument::contractedChanged, &PlantDocument::unitChanged})
    connect(&document, signal, &timer_, qOverload<>(&QTimer::start)); // the view forgets colors
  choose();
}

void ValueColors::choose() {
  nodeColor_.clear();
  for (const QAction* action : parts_.options.nodeColors())
    if (action->isChecked()) nodeColor_ = action->objectName();
  pointColor_.clear();
  for (const QString& id : {byDistance, byDisplacement, byOrgan})
    if (parts_.actions[id]->isChecked()) pointColor_ = id;
  parts_.distances.setWanted(ScanDistances::Use::nodeColors,
                             nodeColor_ == "node_color_distance" ||
                                 nodeColor_ == "node_color_confidence");
  parts_.distances.setWanted(ScanDistances::Use::pointColors, pointColor_ == byDistance);
  parts_.organs.setWanted(pointColor_ == byOrgan);
  show();
}

void ValueColors::show() {
  timer_.stop();
  colorNodes();
  colorPoints();
}

void ValueColors::colorNodes() {
  if (nodeColor_ == "node_color_comparison") return; // EvaluationFlow colors them
  const Skeleton& skeleton = parts_.document.skeleton();
  if (nodeColor_ == "node_color_review")
    return parts_.view.setNodeColors(reviewColors(skeleton, isDark_));
  const auto value = valuesById().find(nodeColor_);
  if (value == valuesById().end() || skeleton.isEmpty())
    return parts_.view.setNodeColors(std::nullopt);
  const Scan* scan = parts_.document.scan();
  const auto values = nodeValues(skeleton, value->second, parts_.distances.now().get(),
                                 scan != nullptr ? scan->spacing() : 0);
  if (std::ranges::none_of(values, [](const auto& each) { return each.has_value(); }))
    return parts_.view.setNodeColors(std::nullopt);
  const bool isShare =
      value->second == NodeValue::confidence || value->second == NodeValue::radiusSpread;
  const double unit = isShare ? 100 : 1; // percent
  NodeColors colors;
  std::vector<double> known;
  for (const std::optional<double>& each : values) {
    colors.values.push_back(each ? static_cast<float>(unit * *each) : asUsual);
    if (each) known.push_back(unit * *each);
  }
  colors.legend = legendOf(nodeColor_, known);
  colors.legend.id = nodeColor_;
  colors.legend.histogram = histogramOf(known, {colors.legend.from, colors.legend.to});
  parts_.view.setNodeColors(std::move(colors));
}

void ValueColors::setDark(bool isDark) {
  isDark_ = isDark;
  colorNodes();
}

void ValueColors::setPreviewed(std::shared_ptr<const Eigen::Matrix3Xf> contracted,
                               std::vector<Eigen::Index> points) {
  if (contracted == previewed_) return;
  previewed_ = std::move(contracted);
  previewedPoints_ = std::move(points);
  if (pointColor_ == byDisplacement) colorPoints(); // at once: they are seen already
}

void ValueColors::colorPoints() {
  std::optional<PointValues> values = pointValues();
  if (!values && !std::exchange(hasPointValues_, false)) return;
  hasPointValues_ = values.has_value();
  parts_.view.setPointValues(std::move(values));
}

std::optional<PointValues> ValueColors::pointValues() const {
  if (pointColor_ == byDistance && parts_.distances.now()) return distances();
  if (pointColor_ == byOrgan) return organs();
  const Scan* scan = parts_.document.scan();
  if (pointColor_ != byDisplacement || scan == nullptr) return std::nullopt;
  const auto& contracted = previewed_ ? previewed_ : parts_.document.contracted();
  if (!contracted) return std::nullopt;
  if (previewed_ && !previewedPoints_.empty()) return shownDisplacements(displacementsInPart());
  if (contracted->cols() != scan->cloud()->size()) return std::nullopt;
  return shownDisplacements(displacements(scan->cloud()->positions(), *contracted));
}

/// Of points elsewhere nothing is known: they are drawn as usual.
std::vector<float> ValueColors::displacementsInPart() const {
  const Eigen::Matrix3Xf& scanned = parts_.document.scan()->cloud()->positions();
  std::vector<float> moved(static_cast<std::size_t>(scanned.cols()), asUsual);
  for (Eigen::Index i = 0; i < previewed_->cols(); ++i) {
    const Eigen::Index point = previewedPoints_[static_cast<std::size_t>(i)];
    moved[static_cast<std::size_t>(point)] = (previewed_->col(i) - scanned.col(point)).norm();
  }
  return moved;
}

/// Blue inside the wood, neutral on its surface, and vermillion where wood is missing.
PointValues ValueColors::distances() const {
  std::vector<float> sizes = parts_.distances.now()->toSurface();
  for (float& size : sizes)
    size = std::abs(size);
  const double most = nearlyLargest(std::move(sizes));
  auto values = std::make_shared<const std::vector<float>>(parts_.distances.toSurface());
  Legend legend{.id = byDistance,
                .title = tr("To the surface"),
                .unit = symbol(parts_.document.unit()),
                .map = ColorMap::diverging,
                .from = -most,
                .to = most,
                .histogram = histogramOf({values->begin(), values->end()}, {-most, most}),
                .categories = {}};
  return {.values = values, .legend = std::move(legend)};
}

/// Colors of which each stands out from both backgrounds at 3 to 1, and from the others for those
/// who see no red or green.
std::optional<PointValues> ValueColors::organs() const {
  auto values = parts_.organs.now();
  if (!values) return std::nullopt;
  return PointValues{.values = std::move(values),
                     .legend = {.id = byOrgan,
                                .title = tr("Organ"),
                                .unit = {},
                                .categories = {{tr("Wood"), {0x8c, 0x6d, 0x46}},
                                               {tr("Petiole"), {0xcc, 0x79, 0xa7}},
                                               {tr("Blade"), {0x00, 0x9e, 0x73}},
                                               {tr("Needle"), {0x00, 0x72, 0xb2}}}}};
}

PointValues ValueColors::shownDisplacements(std::vector<float> lengths) const {
  std::vector<double> known(lengths.begin(), lengths.end());
  std::erase_if(known, [](double length) { return std::isnan(length); });
  const double most = nearlyLargest(known);
  Legend legend{.id = byDisplacement,
                .title = tr("Displacement"),
                .unit = symbol(parts_.document.unit()),
                .to = most,
                .histogram = histogramOf(known, {0, most}),
                .categories = {}};
  return {.values = std::make_shared<const std::vector<float>>(std::move(lengths)),
          .legend = std::move(legend)};
}

Legend ValueColors::legendOf(const QString& id, std::vector<double> known) const {
  const QString unit = symbol(parts_.document.unit());
  if (id == "node_color_order")
    return {.title = tr("Order"),
            .unit = {},
            .to = std::max(1.0, *std::ranges::max_element(known)),
            .categories = {}};
  if (id == "node_color_radius_to_parent")
    return {.title = tr("Radius / parent's"),
            .unit = {},
            .map = ColorMap::diverging,
            .from = 0,
            .to = 2,
            .middle = 1, // thicker than the parent: beyond it
            .categories = {}};
  if (id == "node_color_confidence")
    return {.title = tr("Scanned"), .unit = "%", .to = 100, .categories = {}};
  if (id == "node_color_radius_spread")
    return {.title = tr("Radius ±"), .unit = "%", .to = 100, .categories = {}};
  const QString title = id == "node_color_radius" ? tr("Radius") : tr("To its points");
  return {.title = title, .unit = unit, .to = nearlyLargest(std::move(known)), .categories = {}};
}

} // namespace espalier
