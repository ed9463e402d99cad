#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace espalier {

/// An array in a MAT file of level 5. Views into bytes that must outlive it.
struct MatArray {
  enum class Kind : std::uint8_t { numbers, structure, other };

  Kind kind = Kind::other;
  std::string name;
  std::uint64_t rows = 0;
  std::uint64_t columns = 0;                                    // all dimensions but the first
  std::vector<std::pair<std::string, std::string_view>> fields; // of a structure's first element
  std::vector<double> values; // of numbers: rows x columns, column by column
};

/// Reads MAT files of level 5, as MATLAB 5 to 7 saves them, compressed or not: numbers and
/// structures, whatever else is in them passed over.
///
/// Specification: MathWorks, "MAT-File Format", 2019; RFC 1950 of the streams in it.
class MatFile {
public:
  /// @param bytes  must outlive this
  /// @param file   its name, for messages
  /// @throws Error if it does not begin as such a file
  MatFile(std::string_view bytes, std::string file);

  /// Unpacks the next variable; its bytes are in `unpacked`, which what is read from it views.
  /// @return whether there is one
  /// @throws Error if it is cut short or damaged, or unpacks to more than 128 MiB, or all
  ///         so far to more than 1 GiB
  bool next(std::string& unpacked);

  /// What a variable or a field is; the values of numbers are read too.
  /// @throws Error if it is cut short, has another number of values than its size states, or over
  ///         2^22 of them
  /// Time and memory O(size of the array).
  [[nodiscard]] MatArray array(std::string_view matrix) const;

private:
  std::string_view bytes_;
  std::string file_;
  std::size_t offset_ = 0;
  std::size_t unpacked_ = 0; // bytes, of all variables so far
  std::endian order_ = std::endian::little;
};

} // namespace espalier
