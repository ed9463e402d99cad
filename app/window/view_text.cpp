#include "app/window/view_text.h"

#include "core/base/error.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

QJsonArray jsonOf(const Eigen::Vector3d& place) {
  return {place.x(), place.y(), place.z()};
}

[[noreturn]] void refuse() {
  throw Error(QCoreApplication::translate(
                  "ViewText", "the view of this project cannot be read: all of the plant is shown")
                  .toStdString());
}

double numberIn(const QJsonValue& value) {
  const double number = value.toDouble(std::nan(""));
  if (!std::isfinite(number)) refuse();
  return number;
}

Eigen::Vector3d placeIn(const QJsonValue& value) {
  const QJsonArray array = value.toArray();
  if (array.size() != 3) refuse();
  return {numberIn(array[0]), numberIn(array[1]), numberIn(array[2])};
}

Camera cameraIn(const QJsonObject& json) {
  Camera camera{.focus = placeIn(json["focus"]),
                .pivot = placeIn(json["pivot"]),
                .distance = numberIn(json["distance"]),
                .yaw = numberIn(json["yaw"]),
                .pitch = numberIn(json["pitch"]),
                .projection = json["projection"] == "parallel" ? Projection::parallel
                                                               : Projection::perspective};
  if (camera.distance <= 0 || std::abs(camera.pitch) > std::numbers::pi / 2) refuse();
  return camera;
}

} // namespace

std::string textOf(const ViewText& view) {
  const Camera& camera = view.camera;
  QJsonObject layers;
  for (const auto& [id, isShown] : view.layers.asKeyValueRange())
    layers[id] = isShown;
  QJsonObject json{{"camera", QJsonObject{{"focus", jsonOf(camera.focus)},
                                          {"pivot", jsonOf(camera.pivot)},
                                          {"distance", camera.distance},
                                          {"yaw", camera.yaw},
                                          {"pitch", camera.pitch},
                                          {"projection", camera.projection == Projection::parallel
                                                             ? "parallel"
                                                             : "perspective"}}},
                   {"layers", layers}};
  for (const auto& [name, id] : view.choices.asKeyValueRange())
    json[name] = id;
  return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

ViewText viewFrom(const std::string& text) {
  const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
  ViewText view{.camera = cameraIn(json["camera"].toObject())};
  const QJsonObject layers = json["layers"].toObject();
  for (const QString& id : layers.keys())
    view.layers[id] = layers[id].toBool(true);
  for (const QString name : {"color", "point_size"})
    view.choices[name] = json[name].toString();
  return view;
}

} // namespace espalier
