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

QJsonArray columnsJson(const std::vector<PointField>& columns) {
  QJsonArray names;
  for (const PointField field : columns)
    names.append(QString::fromUtf8(nameOf(field).data(), qsizetype(nameOf(field).size())));
  return names;
}

std::vector<PointField> columnsIn(const QJsonArray& names) {
  std::vector<PointField> columns;
  for (const auto& name : names) {
    const std::string text = name.toString().toStdString();
    columns.push_back(pointFieldNamed(text));
    if (nameOf(columns.back()) != text) refuse();
  }
  if (columns.empty()) refuse();
  return columns;
}

} // namespace

std::string textOf(const ScanPart& part) {
  const std::vector<PointField>& columns = part.reading.columns;
  if (!part.isPart() && columns.empty()) return {};
  QJsonObject json;
  if (!columns.empty()) json["columns"] = columnsJson(columns);
  if (part.isPart()) json["points_in_file"] = static_cast<double>(part.listed);
  if (part.reading.most > 0 && part.isPart()) json["most"] = static_cast<double>(part.reading.most);
  if (const auto& box = part.reading.box; box && part.isPart())
    json["box"] = QJsonArray{placeJson(box->min()), placeJson(box->max())};
  return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

ScanPart scanPartIn(const std::string& text) {
  if (text.empty()) return {};
  const QString refusal = QCoreApplication::translate(
      "ScanPart", "which part of the scan the plant is of cannot be read: open the scan again");
  return readKept(refusal, [&] {
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    ScanPart part;
    if (json.contains("columns")) part.reading.columns = columnsIn(json["columns"].toArray());
    if (!json.contains("points_in_file") && !part.reading.columns.empty()) return part;
    part.listed = countIn(json["points_in_file"]);
    if (json.contains("most")) part.reading.most = countIn(json["most"]);
    if (json.contains("box")) {
      const QJsonArray corners = json["box"].toArray();
      part.reading.box.emplace(placeIn(corners.at(0)), placeIn(corners.at(1)));
    }
    return part;
  });
}

} // namespace espalier
