// What text files of points hold.
#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/io/points/point_glances.h"
#include "core/io/points/point_samples.h"
#include "core/io/points/xyz_layout.h"

#include <string>

namespace espalier {
namespace {

/// How its fields are parted. (Where commas part them, none is a decimal one.)
const char* separatorText(const XyzLayout& layout) {
  if (layout.separator == ',') return Shown::tr("parted by commas");
  if (layout.separator == ';')
    return layout.hasDecimalComma ? Shown::tr("parted by semicolons, decimal commas")
                                  : Shown::tr("parted by semicolons");
  return layout.hasDecimalComma ? Shown::tr("parted by blanks, decimal commas")
                                : Shown::tr("parted by blanks");
}

} // namespace

PointGlance glanceAtXyz(ByteSource& source, const std::string& file,
                        const std::vector<PointField>& columns) {
  const XyzLayout layout = xyzLayoutOf(source, file, columns);
  if (layout.columns.empty())
    throw ShownError(
        {Shown::tr("holds no points, a line each of at least 3 numbers"), {}, FilePlace{file}});
  PointGlance glance;
  glance.version = {separatorText(layout)};
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
