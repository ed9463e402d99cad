#include "core/io/points/e57_scans.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace espalier {
namespace {

/// The number that a child of this name holds, 0 if it is empty. None if there is no such child.
std::optional<double> numberOfChild(const XmlFile& xml, pugi::xml_node parent,
                                    const std::string& name) {
  const pugi::xml_node child = parent.child(name.c_str());
  if (!child) return std::nullopt;
  const std::string_view text = trimmed(child.text().get());
  return text.empty() ? 0 : xml.numberIn(child, text, name);
}

std::uint64_t countIn(const XmlFile& xml, pugi::xml_node node, const char* name) {
  const std::string_view text = trimmed(node.attribute(name).value());
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size())
    throw ShownError({espalier::Shown::tr("expected a whole number as %1, found %2"),
                      {name, inQuotes(node.attribute(name).value())},
                      xml.where(node)});
  return value;
}

/// None if the four numbers are no rotation.
std::optional<Eigen::Quaterniond> rotationOf(const XmlFile& xml, pugi::xml_node pose) {
  const pugi::xml_node rotation = pose.child("rotation");
  if (!rotation) return Eigen::Quaterniond::Identity();
  const auto number = [&](const char* name) {
    return numberOfChild(xml, rotation, name).value_or(0);
  };
  const Eigen::Quaterniond turn(number("w"), number("x"), number("y"), number("z"));
  const double length = turn.norm();
  if (!(length > 0.5 && length < 2)) return std::nullopt;
  return turn.normalized();
}

Eigen::Vector3d translationOf(const XmlFile& xml, pugi::xml_node pose) {
  const pugi::xml_node translation = pose.child("translation");
  const auto number = [&](const char* name) {
    return numberOfChild(xml, translation, name).value_or(0);
  };
  return {number("x"), number("y"), number("z")};
}

std::optional<E57Limits> limitsOfField(const std::vector<E57Field>& fields, E57Role role) {
  const auto field = std::ranges::find(fields, role, &E57Field::role);
  return field == fields.end() ? std::nullopt : field->limits;
}

/// The limits of the scanner's camera, else of the fields; none if they do not say how bright the
/// brightest is.
std::optional<std::array<E57Limits, 3>> colorLimitsOf(const XmlFile& xml, pugi::xml_node scan,
                                                      const std::vector<E57Field>& fields) {
  struct Channel {
    const char* name;
    E57Role role;
  };
  constexpr std::array<Channel, 3> channels = {
      {{"colorRed", E57Role::red}, {"colorGreen", E57Role::green}, {"colorBlue", E57Role::blue}}};
  const pugi::xml_node stated = scan.child("colorLimits");
  std::array<E57Limits, 3> limits;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::string name = channels[i].name;
    limits[i] = {numberOfChild(xml, stated, name + "Minimum").value_or(0),
                 numberOfChild(xml, stated, name + "Maximum").value_or(0)};
    if (!limits[i].areSensible())
      limits[i] = limitsOfField(fields, channels[i].role).value_or(E57Limits{});
    if (!limits[i].areSensible()) return std::nullopt;
  }
  return limits;
}

/// E57 1.0 knows one codec, which is also what is meant where none is named.
void refuseOtherCodecs(const XmlFile& xml, pugi::xml_node points) {
  for (const pugi::xml_node codec : points.child("codecs").children())
    for (const pugi::xml_node kind : codec.children())
      if (const std::string_view name = kind.name(); name != "inputs" && name != "bitPackCodec")
        throw ShownError({Shown::tr("the points are packed by %1, which E57 1.0 does not know: "
                                    "export them again, as E57 1.0"),
                          {inQuotes(name)},
                          xml.where(kind)});
}

/// All of a scan but how it is turned.
E57Scan scanOf(const XmlFile& xml, pugi::xml_node node, pugi::xml_node points) {
  E57Scan scan;
  scan.fields = e57FieldsOf(xml, points.child("prototype"));
  scan.start = countIn(xml, points, "fileOffset");
  scan.records = countIn(xml, points, "recordCount");
  scan.colorLimits = colorLimitsOf(xml, node, scan.fields);
  scan.pose.translation() = translationOf(xml, node.child("pose"));
  scan.name = trimmed(node.child("name").text().get());
  scan.hasPose = !node.child("pose").empty();
  return scan;
}

} // namespace

Imported<std::vector<E57Scan>> e57ScansOf(const XmlFile& xml) {
  Imported<std::vector<E57Scan>> scans;
  std::size_t number = 0;
  for (const pugi::xml_node node : xml.root().child("data3D").children()) {
    if (node.type() != pugi::node_element) continue;
    ++number;
    const pugi::xml_node points = node.child("points");
    // Of scans without points, writers leave the rest as it comes.
    if (!points || countIn(xml, points, "recordCount") == 0) continue;
    refuseOtherCodecs(xml, points);
    scans.value.push_back(scanOf(xml, node, points));
    const pugi::xml_node pose = node.child("pose");
    if (const auto rotation = rotationOf(xml, pose))
      scans.value.back().pose.linear() = rotation->toRotationMatrix();
    else
      scans.notes.push_back({Shown::tr("the rotation of station %1 is no unit quaternion: its "
                                       "points are moved, not turned"),
                             {std::to_string(number)},
                             xml.where(pose)});
  }
  return scans;
}

} // namespace espalier
