#pragma once

#include "core/base/error.h"
#include "core/base/shown.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// The place in a file that something is said of: all of it, a line, a field of a line, or a byte.
struct FilePlace {
  std::string file;                       // its path, as it was named
  std::optional<std::size_t> line = {};   // from 1
  std::optional<std::size_t> column = {}; // of that line, from 1
  std::optional<std::uint64_t> byte = {}; // from 0

  bool operator==(const FilePlace&) const = default;
};

/// "oak.mtg, line 12, column 3"
[[nodiscard]] std::string inEnglish(const FilePlace& place);

/// A sentence with what is put into it, which the window can translate
/// (ui/document/shown_message.h): text that is joined of pieces could not be. One and many have a
/// sentence each.
struct ShownMessage {
  std::string sentence;                 // marked by Shown::tr(), with %1 ... %9 for the values
  std::vector<std::string> values = {}; // numbers, names and texts of the user
  std::optional<FilePlace> where = {};  // which the text begins with: "oak.mtg, line 12: "

  bool operator==(const ShownMessage&) const = default;
};

/// The whole sentence in English, behind its place in a file if it has one.
[[nodiscard]] std::string inEnglish(const ShownMessage& message);

[[nodiscard]] std::vector<std::string> eachInEnglish(const std::vector<ShownMessage>& messages);

/// What an error says: that of a ShownError, or its text, which stays as it is.
[[nodiscard]] ShownMessage messageOf(const std::exception& error);

/// An Error that the window shows in its language.
class ShownError : public Error {
public:
  explicit ShownError(ShownMessage message);

  [[nodiscard]] const ShownMessage& message() const { return message_; }

private:
  ShownMessage message_;
};

} // namespace espalier
