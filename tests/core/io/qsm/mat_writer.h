#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace espalier::test {

/// Types of numbers in MAT files of level 5, by what MathWorks calls them.
enum class MatType : std::uint8_t { int8 = 1, uint16 = 4, uint32 = 6, single = 7, real = 9 };

/// An array of numbers, column by column.
struct MatNumbers {
  std::uint32_t rows = 0;
  std::uint32_t columns = 0;
  std::vector<double> values;
  MatType type = MatType::single;
};

using MatFields = std::vector<std::pair<std::string, std::string>>; // names and elements

[[nodiscard]] std::string matElement(const MatNumbers& numbers, const std::string& name = {});

/// A structure of 1 x `count` elements that all have the same fields.
[[nodiscard]] std::string matStruct(const std::string& name, const MatFields& fields,
                                    std::uint32_t count = 1);

/// A file of these elements; compressed: each as a stream of zlib.
[[nodiscard]] std::string matFile(const std::vector<std::string>& elements, bool isCompressed);

/// The fields of the cylinders of `treeQsmTable`, in the types that TreeQSM gives them.
[[nodiscard]] std::vector<std::pair<std::string, MatNumbers>> qsmFields();
[[nodiscard]] MatFields elementsOf(const std::vector<std::pair<std::string, MatNumbers>>& fields);
[[nodiscard]] std::string qsmMatFile(); // of these, compressed

} // namespace espalier::test
