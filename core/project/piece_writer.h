#pragma once

#include "core/base/progress.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace espalier {

class Project;

/// Writes bytes of a project a piece at a time, so that others can write in between.
///
/// Each piece is on the disk when writeNext() returns. What there was of this name goes with the
/// first; the new bytes are there once the last is written, and until then there are none.
class PieceWriter {
public:
  static constexpr std::size_t standardSize = std::size_t{1} << 20; // some milliseconds on a disk

  PieceWriter(std::string name, std::string bytes, std::size_t pieceSize = standardSize);

  [[nodiscard]] bool isDone() const { return hasBegun_ && left_ == 0; }
  [[nodiscard]] double fraction() const; // done, in [0, 1]
  /// @throws Error as Project::setBytes; the piece can be tried again
  void writeNext(Project& project); // pre: !isDone()

private:
  std::string name_;
  std::string bytes_;
  std::size_t pieceSize_;
  std::size_t count_;
  std::size_t left_; // pieces
  bool hasBegun_ = false;
};

/// Writes bytes of a project, as setBytes() does, from a worker.
/// @throws Cancelled if `progress` asks to stop; then there are none of this name
/// @throws Error     as Project::setBytes; likewise, if the disk allows it
void writeBytes(Project& project, const std::string& name, std::string bytes,
                const Progress& progress);

} // namespace espalier
