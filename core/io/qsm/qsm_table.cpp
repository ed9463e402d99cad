#include "core/io/qsm/qsm_table.h"

#include "core/base/listed.h"
#include "core/base/text.h"
#include "core/io/qsm/qsm.h"
#include "core/io/qsm/qsm_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace espalier {
namespace {

using enum QsmField;

constexpr std::size_t headSize = 4096; // bytes by which columns are recognized

/// A line of the table.
class Row {
public:
  Row(std::string_view line, const QsmColumns& columns, FilePlace where)
      : fields_(qsmFields(line, columns.separator)), columns_(columns), where_(std::move(where)) {
    while (fields_.size() > columns.count && fields_.back().empty())
      fields_.pop_back(); // a separator at the end of the line
    if (fields_.size() != columns.count)
      throw ShownError({espalier::Shown::tr("expected %1 columns, found %2"),
                        {std::to_string(columns.count), std::to_string(fields_.size())},
                        where_});
  }

  [[nodiscard]] bool has(QsmField field) const {
    return columns_[field] && !fields_[*columns_[field]].empty();
  }

  [[nodiscard]] double number(QsmField field) const {
    const std::string_view text = fields_[*columns_[field]];
    const auto value = numberIn(text);
    if (!value || !std::isfinite(*value))
      throw ShownError({espalier::Shown::tr("expected a number in column %1, found %2"),
                        {std::to_string(*columns_[field] + 1), inQuotes(text)},
                        where_});
    return *value;
  }

  [[nodiscard]] Eigen::Vector3d vector(QsmField x) const {
    const auto at = [&](int axis) {
      return number(static_cast<QsmField>(static_cast<int>(x) + axis));
    };
    return {at(0), at(1), at(2)};
  }

  /// A whole number; 0 where the column is missing or empty, or says NA or -1.
  [[nodiscard]] std::uint32_t count(QsmField field) const {
    if (!has(field)) return 0;
    const std::string_view text = fields_[*columns_[field]];
    if (text == "NA" || text == "-1") return 0;
    const double value = number(field);
    if (value < 0 || value != std::floor(value) ||
        value > std::numeric_limits<std::uint32_t>::max())
      throw ShownError({espalier::Shown::tr("expected a whole number in column %1, found %2"),
                        {std::to_string(*columns_[field] + 1), inQuotes(text)},
                        where_});
    return static_cast<std::uint32_t>(value);
  }

private:
  std::vector<std::string_view> fields_;
  const QsmColumns& columns_;
  FilePlace where_;
};

QsmCylinder cylinderIn(const Row& row, const QsmColumns& columns, const FilePlace& where) {
  QsmCylinder cylinder{.radius = row.number(radius), .start = row.vector(startX)};
  if (columns[endX] && columns[endY] && columns[endZ]) {
    cylinder.end = row.vector(endX);
  } else {
    const double size = row.number(length);
    const Eigen::Vector3d axis = row.vector(axisX);
    if (size < 0) throw ShownError({espalier::Shown::tr("the length is negative"), {}, where});
    if (size > 0 && axis.isZero(0))
      throw ShownError({espalier::Shown::tr("the axis has no direction"), {}, where});
    cylinder.end = qsmEnd(cylinder.start, axis, size);
  }
  if (row.has(startRadius)) cylinder.startRadius = row.number(startRadius);
  cylinder.parent = row.count(parent);
  cylinder.extension = row.count(extension);
  cylinder.branch = row.count(branch);
  cylinder.order = row.count(order);
  return cylinder;
}

void checkFinite(const Skeleton& skeleton) {
  for (const NodeId id : skeleton.ids())
    if (!skeleton[id].position.allFinite() || !std::isfinite(skeleton[id].radius))
      throw ShownError(
          {espalier::Shown::tr(
               "node %1 has a position or radius that is not finite: move or remove it"),
           {std::to_string(indexOf(id))}});
}

} // namespace

bool isQsmTable(std::string_view beginning) {
  return qsmColumnsIn(beginning).has_value();
}

Imported<Skeleton> readQsmTable(std::istream& in, const std::string& file) {
  const std::string bytes = readAll(in);
  const auto columns = qsmColumnsIn(std::string_view(bytes).substr(0, headSize));
  if (!columns)
    throw ShownError(
        {espalier::Shown::tr("is no table of cylinders: its first line should name the columns "
                             "radius, length, start_x ..., axis_x ..., parent, as TreeQSM does"),
         {},
         FilePlace{file}});
  Qsm qsm{.cylinders = {},
          .hasExtensions = (*columns)[extension].has_value(),
          .hasBranches = (*columns)[branch].has_value(),
          .hasOrders = (*columns)[QsmField::order].has_value()};
  LineReader lines(bytes);
  if (columns->hasHeader) (void)lines.next();
  while (const auto line = lines.next()) {
    if (trimmed(*line).empty()) continue;
    const FilePlace where{file, lines.number()};
    qsm.cylinders.push_back(cylinderIn(Row(*line, *columns, where), *columns, where));
    qsm.cylinders.back().line = lines.number();
  }
  Imported<Skeleton> result = skeletonOf(qsm, file);
  if (!columns->leftOut.empty())
    result.notes.push_back({espalier::Shown::tr("columns that are not kept: %1"),
                            {listed(columns->leftOut)},
                            FilePlace{file}});
  return result;
}

void writeQsmTable(std::ostream& out, const Skeleton& skeleton) {
  checkFinite(skeleton);
  const Qsm qsm = qsmOf(skeleton);
  out << "radius,length,start_x,start_y,start_z,axis_x,axis_y,axis_z,parent,extension,branch,"
         "BranchOrder,PositionInBranch,added,UnmodRadius,end_x,end_y,end_z,start_radius\n";
  std::uint32_t position = 0;
  std::uint32_t lastBranch = 0;
  for (const QsmCylinder& cylinder : qsm.cylinders) {
    position = cylinder.branch == lastBranch ? position + 1 : 1;
    lastBranch = cylinder.branch;
    const Eigen::Vector3d along = cylinder.end - cylinder.start;
    const double size = along.norm();
    std::string line = plainDecimal(cylinder.radius) + ',' + plainDecimal(size);
    const auto append = [&](const Eigen::Vector3d& vector) {
      for (const double x : vector)
        line += ',' + plainDecimal(x);
    };
    append(cylinder.start);
    append(size > 0 ? Eigen::Vector3d(along / size) : Eigen::Vector3d::Zero());
    for (const std::uint32_t number :
         {cylinder.parent, cylinder.extension, cylinder.branch, cylinder.order, position})
      line += ',' + std::to_string(number);
    line += ",0," + plainDecimal(cylinder.radius);
    append(cylinder.end);
    line += ',' + (cylinder.startRadius ? plainDecimal(*cylinder.startRadius) : std::string());
    out << line << '\n';
  }
}

} // namespace espalier
