#include "app/window/files/scan_part.h"

#include "app/window/frame/kept_json.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace espalier {
namespace {

QJsonArray placeJson(const Eigen::Vector3d& place) {
  return {place.x(), place.y(), place.z()};
}

Eigen::Vector3d placeIn(const QJsonValue& value) {
  const QJsonArray numbers = value.toArray();
  return {numberIn(numbers.at(0)), numberIn(numbers.at(1)), numberIn(numbers.at(2))};
}

/// Whole numbers that a double holds exactly.
std::uint64_t countIn(const QJsonValue& value) {
  constexpr double most = 9e15;
  const double number = numberIn(value);
  if (number < 1 || number > most) refuse();
  return static_cast<std::uint64_t>(number);
}

} // namespace

std::string textOf(const ScanPart& part) {
  if (!part.isPart()) return {};
  QJsonObject json{{"points_in_file", static_cast<double>(part.listed)}};
  if (part.reading.most > 0) json["most"] = static_cast<double>(part.reading.most);
  if (const auto& box = part.reading.box)
    json["box"] = QJsonArray{placeJson(box->min()), placeJson(box->max())};
  return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

ScanPart scanPartIn(const std::string& text) {
  if (text.empty()) return {};
  const QString refusal = QCoreApplication::translate(
      "ScanPart", "which part of the scan the plant is of cannot be read: open the scan again");
  return readKept(refusal, [&] {
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    ScanPart part{.listed = countIn(json["points_in_file"])};
    if (json.contains("most")) part.reading.most = countIn(json["most"]);
    if (json.contains("box")) {
      const QJsonArray corners = json["box"].toArray();
      part.reading.box.emplace(placeIn(corners.at(0)), placeIn(corners.at(1)));
    }
    return part;
  });
}

} // namespace espalier
