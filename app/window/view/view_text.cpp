#include "app/window/view/view_text.h"

#include "app/window/frame/kept_json.h"

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

QJsonObject jsonOf(const Camera& camera) {
  return {{"focus", jsonOf(camera.focus)},
          {"pivot", jsonOf(camera.pivot)},
          {"distance", camera.distance},
          {"yaw", camera.yaw},
          {"pitch", camera.pitch},
          {"projection", camera.projection == Projection::parallel ? "parallel" : "perspective"}};
}

void addClip(QJsonObject& json, const Clip& clip) {
  if (clip.slab) json["slab"] = QJsonArray{clip.slab->nearest, clip.slab->farthest};
  if (clip.box) json["box"] = QJsonArray{jsonOf(clip.box->min()), jsonOf(clip.box->max())};
}

QJsonObject jsonOf(const SavedView& view) {
  QJsonArray hidden;
  for (const NodeId id : view.hidden)
    hidden.append(qint64(indexOf(id)));
  QJsonObject json{{"name", view.name},
                   {"camera", jsonOf(view.camera)},
                   {"depth_fade", view.depthFade},
                   {"hidden", hidden}};
  addClip(json, view.clip);
  return json;
}

Clip clipIn(const QJsonObject& json) {
  Clip clip;
  if (const QJsonArray slab = json["slab"].toArray(); !slab.isEmpty()) {
    clip.slab = Clip::Slab{numberIn(slab[0]), numberIn(slab[1])};
    if (clip.slab->farthest < clip.slab->nearest) refuse();
  }
  if (const QJsonArray box = json["box"].toArray(); !box.isEmpty())
    clip.box = Eigen::AlignedBox3d(placeIn(box[0]), placeIn(box[1]));
  return clip;
}

SavedView savedIn(const QJsonObject& json) {
  SavedView view{.name = json["name"].toString(),
                 .camera = cameraIn(json["camera"].toObject()),
                 .clip = clipIn(json),
                 .depthFade = json["depth_fade"].toDouble(0),
                 .hidden = {}};
  for (const QJsonValue value : json["hidden"].toArray()) {
    view.hidden.push_back(nodeIn(value));
  }
  return view;
}

std::map<QString, ValueRange> rangesIn(const QJsonObject& json) {
  std::map<QString, ValueRange> ranges;
  for (const QString& id : json.keys()) {
    const QJsonArray ends = json[id].toArray();
    if (ends.size() != 2) refuse();
    const ValueRange range{numberIn(ends[0]), numberIn(ends[1])};
    if (!(range.from < range.to)) refuse();
    ranges.emplace(id, range);
  }
  return ranges;
}

} // namespace

const QStringList& choiceNames() {
  static const QStringList names = {"color", "node_color", "point_size", "point_map", "node_map"};
  return names;
}

std::string textOf(const ViewText& view) {
  QJsonObject layers;
  for (const auto& [id, isShown] : view.layers.asKeyValueRange())
    layers[id] = isShown;
  QJsonArray saved;
  for (const SavedView& one : view.saved)
    saved.append(jsonOf(one));
  QJsonObject json{{"camera", jsonOf(view.camera)}, {"layers", layers}};
  if (!saved.isEmpty()) json["saved"] = saved;
  QJsonObject ranges;
  for (const auto& [id, range] : view.ranges)
    ranges[id] = QJsonArray{range.from, range.to};
  if (!ranges.isEmpty()) json["ranges"] = ranges;
  addClip(json, view.clip);
  if (view.depthFade > 0) json["depth_fade"] = view.depthFade;
  for (const auto& [name, id] : view.choices.asKeyValueRange())
    json[name] = id;
  return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

ViewText viewFrom(const std::string& text) {
  const QString refusal = QCoreApplication::translate(
      "ViewText", "the view of this project cannot be read: all of the plant is shown");
  return readKept(refusal, [&] {
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    ViewText view{.camera = cameraIn(json["camera"].toObject()),
                  .layers = {},
                  .choices = {},
                  .ranges = rangesIn(json["ranges"].toObject()),
                  .clip = clipIn(json),
                  .depthFade = json["depth_fade"].toDouble(0)};
    const QJsonObject layers = json["layers"].toObject();
    for (const QString& id : layers.keys())
      view.layers[id] = layers[id].toBool(true);
    for (const QString& name : choiceNames())
      if (json.contains(name)) view.choices[name] = json[name].toString();
    for (const QJsonValue one : json["saved"].toArray())
      view.saved.push_back(savedIn(one.toObject()));
    return view;
  });
}

} // namespace espalier
