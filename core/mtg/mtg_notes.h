#pragma once

#include "core/base/shown_message.h"

#include <cstddef>
#include <string>
#include <vector>

namespace espalier {

/// What was repaired to read a file. The first 20 are kept as they are, the others counted, so that
/// a broken file cannot drown its user.
class MtgNotes {
public:
  explicit MtgNotes(std::string file, bool isStrict);

  /// @throws ShownError with this text if nothing is to be repaired
  void repaired(const FilePlace& where, ShownMessage what);

  void add(ShownMessage what); // of the whole file

  [[nodiscard]] std::vector<ShownMessage> take(); // all, in order

  [[nodiscard]] const std::string& file() const { return file_; }

private:
  std::string file_;
  bool isStrict_;
  std::vector<ShownMessage> notes_;
  std::size_t repairs_ = 0;
};

/// For messages; columns are those of a spreadsheet, from 0 here.
[[nodiscard]] FilePlace mtgCell(const std::string& file, std::size_t line, std::size_t column);

} // namespace espalier
