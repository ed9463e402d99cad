#include "core/project/piece_writer.h"

#include "core/base/error.h"
#include "core/project/project.h"

#include <cassert>
#include <string_view>
#include <utility>

namespace espalier {

PieceWriter::PieceWriter(std::string name, std::string bytes, std::size_t pieceSize)
    : name_(std::move(name)), bytes_(std::move(bytes)), pieceSize_(pieceSize),
      count_((bytes_.size() + pieceSize - 1) / pieceSize), left_(count_) {}

double PieceWriter::fraction() const {
  if (count_ == 0) return hasBegun_ ? 1 : 0;
  return 1 - static_cast<double>(left_) / static_cast<double>(count_);
}

// From the end: the first piece, without which there are no bytes, comes last.
void PieceWriter::writeNext(Project& project) {
  assert(!isDone());
  if (!hasBegun_) project.setBytes(name_, {});
  hasBegun_ = true;
  if (left_ == 0) return;
  const std::string_view piece =
      std::string_view(bytes_).substr((left_ - 1) * pieceSize_, pieceSize_);
  project.setPiece(name_, static_cast<std::int64_t>(left_ - 1), piece);
  --left_;
}

void writeBytes(Project& project, const std::string& name, std::string bytes,
                const Progress& progress) {
  PieceWriter writer(name, std::move(bytes));
  try {
    while (!writer.isDone()) {
      progress.update(writer.fraction());
      writer.writeNext(project);
    }
  } catch (...) {
    try {
      project.setBytes(name, {});
    } catch (const Error&) { // pieces without the first are none
    }
    throw;
  }
}

} // namespace espalier
