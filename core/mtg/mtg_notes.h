#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace espalier {

/// What was repaired to read a file. The first 20 are kept as they are, the others counted, so that
/// a broken file cannot drown its user.
class MtgNotes {
public:
  explicit MtgNotes(std::string file, bool isStrict);

  /// @param where  "plant.mtg, line 12, column 3: "
  /// @throws Error with this text if nothing is to be repaired
  void repaired(const std::string& where, const std::string& what);

  void add(const std::string& what); // of the whole file

  [[nodiscard]] std::vector<std::string> take(); // all, in order

  [[nodiscard]] const std::string& file() const { return file_; }

private:
  std::string file_;
  bool isStrict_;
  std::vector<std::string> notes_;
  std::size_t repairs_ = 0;
};

/// "plant.mtg, line 12, column 3: ", for the start of messages; columns are those of a spreadsheet,
/// from 0 here.
[[nodiscard]] std::string mtgCell(const std::string& file, std::size_t line, std::size_t column);

} // namespace espalier
