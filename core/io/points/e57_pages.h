#pragma once

#include "core/base/progress.h"
#include "core/base/shown_message.h"
#include "core/io/bytes/byte_source.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace espalier {

/// What the first 48 bytes of an E57 file say.
struct E57Header {
  std::uint32_t minorVersion = 0;
  std::uint64_t size = 0; // of the file, whole pages
  std::uint64_t xmlStart = 0;
  std::uint64_t xmlSize = 0; // without checksums
};

/// @param bytes     the first 48, or more
/// @param fileSize  bytes there are
/// @throws Error if it is no E57 file that can be read, or is cut short
[[nodiscard]] E57Header readE57Header(std::string_view bytes, std::uint64_t fileSize,
                                      const std::string& file);

/// The section of XML, of whose pages alone the checksums are checked.
/// @throws Error as E57Pages
[[nodiscard]] std::string e57XmlOf(ByteSource& source, const std::string& file);

/// The content of an E57 file: its pages without the checksums that end them.
///
/// A file is a row of pages of 1024 bytes; the last 4 are the CRC-32C of the others. Places in the
/// file count all bytes; places in the content leave the checksums out. Pages are read, and their
/// checksums checked, where they are asked for; about 1 MB of them is in memory at a time.
class E57Pages {
public:
  /// Checks the first bytes of the file.
  /// @param source  must outlive the pages
  /// @param file    its name, for messages
  /// @throws Error if the file is no E57 file or is cut short
  E57Pages(ByteSource& source, std::string file);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] std::uint64_t size() const { return size_; } // of the content

  /// The place in the content of byte `inFile` of the file.
  /// @param ifNone  the sentence that says so, with %1 for that byte
  /// @throws Error if there is none
  [[nodiscard]] std::uint64_t placeOf(std::uint64_t inFile, const char* ifNone) const;

  /// @param place   in the content
  /// @param ifLess  the sentence that says so, with %1 for the size, %2 for the bytes that follow
  /// @throws Error if so many bytes do not follow
  void require(std::uint64_t place, std::uint64_t size, const char* ifLess) const;

  /// The bytes from a place in the content on, which are there until the next call.
  /// @throws Error if so many do not follow, or a page is damaged: the message names the page
  [[nodiscard]] std::string_view bytesAt(std::uint64_t place, std::size_t size, const char* ifLess);

  /// @param place  in the content; the message has its place in the file: "oak.e57, byte 1030: ..."
  [[noreturn]] void fail(std::uint64_t place, ShownMessage what) const;

private:
  ByteSource& source_;
  std::string file_;
  std::uint64_t pages_ = 0; // of the file
  std::uint64_t size_ = 0;
  std::string window_; // content of some pages
  std::uint64_t windowStart_ = 0;
};

} // namespace espalier
