#include "core/io/qsm/qsm_mat.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/io/qsm/mat_file.h"
#include "core/io/qsm/qsm.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {
namespace {

constexpr double longestError = 0.01; // of the length of an axis: numbers are single

std::optional<std::string_view> fieldOf(const MatArray& structure, std::string_view name) {
  for (const auto& [field, matrix] : structure.fields)
    if (field == name) return matrix;
  return std::nullopt;
}

bool hasCylinders(const MatArray& structure) {
  return fieldOf(structure, "radius") && fieldOf(structure, "start");
}

/// Reads the cylinders of a model.
class CylinderReader {
public:
  CylinderReader(const MatFile& mat, const MatArray& cylinder, const std::string& file)
      : mat_(mat), cylinder_(cylinder), file_(file) {}

  Qsm read() {
    const MatArray radius = needed("radius", 1, std::nullopt);
    const std::uint64_t count = radius.rows;
    const MatArray length = needed("length", 1, count);
    const MatArray start = needed("start", 3, count);
    const MatArray axis = needed("axis", 3, count);
    const MatArray parent = needed("parent", 1, count);
    const auto extension = optional("extension", count);
    const auto branch = optional("branch", count);
    const auto order = optional("BranchOrder", count);
    Qsm qsm{.cylinders = {},
            .hasExtensions = extension.has_value(),
            .hasBranches = branch.has_value(),
            .hasOrders = order.has_value()};
    for (std::size_t i = 0; i < count; ++i) {
      QsmCylinder one{.radius = radius.values[i], .start = rowOf(start, i)};
      const double size = length.values[i];
      if (size < 0) failAt(i, espalier::Shown::tr("cylinder %1 has a negative length"));
      if (size > 0 && !(std::abs(rowOf(axis, i).norm() - 1) < longestError))
        failAt(i, espalier::Shown::tr("cylinder %1 has an axis that is not of length 1: the file "
                                      "is damaged, save it again"));
      one.end = qsmEnd(one.start, rowOf(axis, i), size);
      one.parent = countIn(parent, i, "parent");
      if (extension) one.extension = countIn(*extension, i, "extension");
      if (branch) one.branch = countIn(*branch, i, "branch");
      if (order) one.order = countIn(*order, i, "BranchOrder");
      qsm.cylinders.push_back(one);
    }
    return qsm;
  }

private:
  [[noreturn]] void fail(ShownMessage what) const {
    what.where = FilePlace{file_};
    throw ShownError(std::move(what));
  }
  /// @param sentence  with %1 for the number of the cylinder, and %2 for the field
  [[noreturn]] void failAt(std::size_t cylinder, const char* sentence,
                           const std::string& field = {}) const {
    fail({sentence, {std::to_string(cylinder + 1), field}});
  }

  static Eigen::Vector3d rowOf(const MatArray& table, std::size_t row) {
    return {table.values[row], table.values[row + table.rows], table.values[row + 2 * table.rows]};
  }

  [[nodiscard]] std::uint32_t countIn(const MatArray& table, std::size_t row,
                                      const std::string& name) const {
    const double value = table.values[row];
    if (!(value >= 0) || value != std::floor(value) ||
        value > std::numeric_limits<std::uint32_t>::max())
      failAt(row, espalier::Shown::tr("cylinder %1 has no whole number as %2"), name);
    return static_cast<std::uint32_t>(value);
  }

  [[nodiscard]] std::optional<MatArray> optional(const std::string& name,
                                                 std::uint64_t rows) const {
    if (!fieldOf(cylinder_, name)) return std::nullopt;
    return needed(name, 1, rows);
  }

  /// @param rows  how many there must be; none: any number
  [[nodiscard]] MatArray needed(const std::string& name, std::uint64_t columns,
                                std::optional<std::uint64_t> rows) const {
    const auto field = fieldOf(cylinder_, name);
    if (!field)
      fail({espalier::Shown::tr(
                "field '%1' of its cylinders is missing: save the whole model of TreeQSM"),
            {name}});
    MatArray table = mat_.array(*field);
    if (table.kind != MatArray::Kind::numbers)
      fail({espalier::Shown::tr("field '%1' of its cylinders is no table of numbers"), {name}});
    if (table.columns != columns || table.rows != rows.value_or(table.rows))
      fail({espalier::Shown::tr("field '%1' of its cylinders has %2 x %3 values, expected %4 x %5"),
            {name, std::to_string(table.rows), std::to_string(table.columns),
             rows ? std::to_string(*rows) : "N", std::to_string(columns)}});
    return table;
  }

  const MatFile& mat_;
  const MatArray& cylinder_;
  const std::string& file_;
};

} // namespace

bool isMat(std::string_view beginning) {
  return beginning.starts_with("MATLAB ") && beginning.find("MAT-file") < 20;
}

Imported<Skeleton> readQsmMat(std::istream& in, const std::string& file) {
  const std::string bytes = readAll(in);
  MatFile mat(bytes, file);
  std::string unpacked;
  while (mat.next(unpacked)) {
    const MatArray variable = mat.array(unpacked);
    if (variable.kind != MatArray::Kind::structure) continue;
    const auto field = fieldOf(variable, "cylinder");
    const MatArray cylinder = hasCylinders(variable) || !field ? variable : mat.array(*field);
    if (!hasCylinders(cylinder)) continue;
    Imported<Skeleton> result = skeletonOf(CylinderReader(mat, cylinder, file).read(), file);
    if (variable.columns > 1)
      result.notes.insert(result.notes.begin(),
                          {espalier::Shown::tr("holds %1 models, of which the first is read"),
                           {std::to_string(variable.columns)},
                           FilePlace{file}});
    return result;
  }
  throw ShownError({espalier::Shown::tr(
                        "holds no model of TreeQSM: expected a structure with a field 'cylinder'"),
                    {},
                    FilePlace{file}});
}

} // namespace espalier
