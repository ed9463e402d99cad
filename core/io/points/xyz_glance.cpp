// What text files of points hold.
#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/io/points/point_glances.h"
#include "core/io/points/point_samples.h"
#include "core/io/points/xyz_layout.h"

#include <string>

namespace espalier {
namespace {

std::string separatorName(const XyzLayout& layout) {
  std::string name = layout.separator == ','   ? "parted by commas"
                     : layout.separator == ';' ? "parted by semicolons"
                                               : "parted by blanks";
  return layout.hasDecimalComma ? name + ", decimal commas" : name;
}

} // namespace

PointGlance glanceAtXyz(ByteSource& source, const std::string& file,
                        const std::vector<PointField>& columns) {
  const XyzLayout layout = xyzLayoutOf(source, file, columns);
  if (layout.columns.empty())
    throw ShownError(
        {Shown::tr("holds no points, a line each of at least 3 numbers"), {}, FilePlace{file}});
  PointGlance glance;
  glance.version = separatorName(layout);
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    const PointField field = layout.columns[i];
    const bool isTaken = field != PointField::none;
    glance.columns.push_back(
        {isTaken ? std::string(nameOf(field)) : "column " + std::to_string(i + 1), "text",
         isTaken});
  }
  const LineSample lines = sampleLines(source, 0, [&](std::string_view line) {
    if (isComment(line)) return false;
    Eigen::Vector3d position;
    for (std::size_t i = 0; i < layout.needed; ++i) {
      const auto number = numberInField(nextField(line, layout.separator), layout.hasDecimalComma);
      const std::size_t axis = indexOf(layout.columns[i]) - indexOf(PointField::x);
      if (axis > 2) continue;
      if (!number) return false;
      position[static_cast<Eigen::Index>(axis)] = *number;
    }
    glance.sample.push_back(position);
    return true;
  });
  glance.points = lines.linesIn(source.size());
  glance.arePointsEstimated = !lines.isAll;
  return glance;
}

} // namespace espalier
