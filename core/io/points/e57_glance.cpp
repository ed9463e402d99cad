// What E57 files say of themselves.
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/points/e57_pages.h"
#include "core/io/points/e57_scans.h"
#include "core/io/points/point_glances.h"

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

/// The bounds that a scan states [L], in the frame of the scanner.
std::optional<Eigen::AlignedBox3d> statedBounds(const XmlFile& xml, pugi::xml_node scan) {
  const pugi::xml_node stated = scan.child("cartesianBounds");
  Eigen::Vector3d least;
  Eigen::Vector3d most;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    for (const auto& [end, side] : {std::pair{"Minimum", &least}, std::pair{"Maximum", &most}}) {
      const pugi::xml_node child = stated.child((name + end).c_str());
      if (!child) return std::nullopt;
      const std::string_view text = trimmed(child.text().get());
      (*side)[axis] = text.empty() ? 0 : xml.numberIn(child, text, child.name());
    }
  }
  if ((least.array() > most.array()).any()) return std::nullopt;
  return Eigen::AlignedBox3d(least, most);
}

const char* kindOf(const pugi::xml_node& field) {
  return field.attribute("type").value();
}

void addColumns(const pugi::xml_node& prototype, const std::vector<E57Field>& fields,
                PointGlance& glance) {
  std::size_t i = 0;
  for (const pugi::xml_node node : prototype.children()) {
    if (node.type() != pugi::node_element || i >= fields.size()) continue;
    const bool isTaken = fields[i].role != E57Role::none;
    ++i;
    const auto same = std::ranges::find(glance.columns, node.name(), &GlanceColumn::name);
    if (same == glance.columns.end())
      glance.columns.push_back({node.name(), kindOf(node), isTaken});
  }
}

} // namespace

PointGlance glanceAtE57(ByteSource& source, const std::string& file) {
  const E57Header header = readE57Header(source.read(0, 48), source.size(), file);
  const XmlFile xml(e57XmlOf(source, file), file + ", XML", "e57Root");
  const auto scans = e57ScansOf(xml).value;
  PointGlance glance;
  glance.version = {"%1", {"1." + std::to_string(header.minorVersion)}};
  glance.stations = scans.size();
  bool areBounded = !scans.empty();
  std::size_t i = 0;
  for (const pugi::xml_node node : xml.root().child("data3D").children()) {
    const pugi::xml_node points = node.child("points");
    // The same scans as e57ScansOf() returns: those with points.
    const bool hasPoints =
        points && trimmed(points.attribute("recordCount").value()).find_first_not_of('0') !=
                      std::string_view::npos;
    if (!hasPoints || i >= scans.size()) continue;
    const E57Scan& scan = scans[i++];
    glance.points += scan.records;
    addColumns(points.child("prototype"), scan.fields, glance);
    const auto box = statedBounds(xml, node);
    areBounded = areBounded && box;
    if (box) glance.bounds.extend(box->transformed(scan.pose));
  }
  if (!areBounded) glance.bounds.setEmpty();
  const pugi::xml_node images = xml.root().child("images2D");
  const auto pictures = std::distance(images.begin(), images.end());
  if (pictures == 1)
    glance.leftOut.push_back({Shown::tr("1 image")});
  else if (pictures > 1)
    glance.leftOut.push_back({Shown::tr("%1 images"), {std::to_string(pictures)}});
  glance.unit = {"m", {Shown::tr("E57 is in meters")}, true};
  glance.up = {"z", {Shown::tr("E57 has z up")}, true};
  return glance;
}

} // namespace espalier
