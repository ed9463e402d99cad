#include "ui/view/point_colors.h"

#include "core/cloud/far_points.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// Between which intensities all but the highest and lowest 2 % are.
ValueRange intensityRange(std::vector<float> values) {
  const auto at = [&](double part) {
    const auto place = values.begin() + std::lround(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return static_cast<double>(*place);
  };
  const double low = at(0.02);
  const double high = at(0.98);
  if (low < high) return {low, high};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return {*least, *most};
}

QString titleOfHeights(UpAxis up) {
  const char* title = up == UpAxis::x   ? QT_TRANSLATE_NOOP("espalier::Overlay", "Height x")
                      : up == UpAxis::y ? QT_TRANSLATE_NOOP("espalier::Overlay", "Height y")
                                        : QT_TRANSLATE_NOOP("espalier::Overlay", "Height z");
  return QCoreApplication::translate("espalier::Overlay", title);
}

} // namespace

double pointValue(const PointCloud& cloud, PointColor by, Eigen::Index point, UpAxis up) {
  if (by == PointColor::intensity)
    return static_cast<double>(cloud.intensities()[static_cast<std::size_t>(point)]);
  const auto row = static_cast<Eigen::Index>(up);
  return cloud.positions()(row, point) + cloud.origin()[row];
}

std::optional<Legend> pointLegend(const PointCloud& cloud, PointColor by, UpAxis up,
                                  const PointSet& leftOut) {
  if (cloud.isEmpty()) return std::nullopt;
  const bool isHeight = by == PointColor::height;
  if (!isHeight && (by != PointColor::intensity || cloud.intensities().empty()))
    return std::nullopt;
  ValueRange range;
  std::vector<double> values;
  if (isHeight) {
    for (const Eigen::Index point :
         others(leftOut | PointSet::of(farPoints(cloud, leftOut)), cloud.size()))
      values.push_back(pointValue(cloud, by, point, up));
    if (values.empty()) return std::nullopt;
    const auto [least, most] = std::ranges::minmax(values);
    range = {least, most};
  } else {
    std::vector<float> counted;
    for (const Eigen::Index point : others(leftOut, cloud.size()))
      counted.push_back(cloud.intensities()[static_cast<std::size_t>(point)]);
    if (counted.empty()) return std::nullopt;
    values.assign(counted.begin(), counted.end());
    range = intensityRange(std::move(counted));
  }
  if (!(range.from < range.to)) return std::nullopt;
  return Legend{.id = isHeight ? "color_height" : "color_intensity",
                .title = isHeight ? titleOfHeights(up)
                                  : QCoreApplication::translate("espalier::Overlay", "Intensity"),
                .unit = {},
                .from = range.from,
                .to = range.to,
                .histogram = histogramOf(values, range),
                .categories = {}};
}

PointColors::PointColors(const PointCloud& cloud, PointColor by,
                         const std::optional<Legend>& legend, bool dark, const Color& plain,
                         UpAxis up)
    : cloud_(&cloud), by_(by), plain_(plain), up_(up) {
  if (legend) map_.emplace(*legend, dark);
}

Color PointColors::operator[](Eigen::Index point) const {
  if (by_ == PointColor::rgb && !cloud_->colors().empty())
    return cloud_->colors()[static_cast<std::size_t>(point)];
  return map_ ? (*map_)(pointValue(*cloud_, by_, point, up_)) : plain_;
}

} // namespace espalier
