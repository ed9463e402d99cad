#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is LAS, compressed (LAZ) or not; `beginning` should be 105 bytes.
[[nodiscard]] bool isLas(std::string_view beginning);
[[nodiscard]] bool isLaz(std::string_view beginning);

inline constexpr std::size_t longestLasHeader = 375; // of version 1.4

/// What the header of a LAS file says, compressed (LAZ) or not.
struct LasHeader {
  int minorVersion = 0;
  std::uint64_t size = 0;        // bytes of the header; variable length records follow
  std::uint64_t pointStart = 0;  // within the file
  std::uint32_t recordCount = 0; // variable length records
  std::size_t format = 0;        // of the points, 0 to 10
  std::size_t pointLength = 0;   // bytes of a point, at least those of its format
  std::uint64_t count = 0;       // points; not checked against the bytes that follow
  Eigen::Vector3d scale;
  Eigen::Vector3d offset;

  /// Where red, green and blue lie in a point; 0: nowhere.
  [[nodiscard]] std::size_t colorStart() const;
};

/// @param bytes  the file
/// @param file   its name, for messages
/// @throws Error if it is no LAS file, is of a later version, or its header is damaged
[[nodiscard]] LasHeader readLasHeader(std::string_view bytes, const std::string& file);

/// The same of the first bytes of a file of `fileSize`: longestLasHeader, or as many as it has.
[[nodiscard]] LasHeader readLasHeader(std::string_view beginning, std::uint64_t fileSize,
                                      const std::string& file);

/// The content of the variable length record of this owner and number; data() is null if there is
/// none.
/// @param head  the file up to its points, or less of it
[[nodiscard]] std::string_view lasRecord(std::string_view head, const LasHeader& header,
                                         std::string_view owner, std::uint16_t number);

} // namespace espalier
