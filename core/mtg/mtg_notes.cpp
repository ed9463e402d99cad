#include "core/mtg/mtg_notes.h"

#include "core/base/error.h"

#include <utility>

namespace espalier {
namespace {

constexpr std::size_t mostRepairs = 20;

} // namespace

MtgNotes::MtgNotes(std::string file, bool isStrict) : file_(std::move(file)), isStrict_(isStrict) {}

void MtgNotes::repaired(const std::string& where, const std::string& what) {
  if (isStrict_) throw Error(where + what);
  if (++repairs_ <= mostRepairs) notes_.push_back(where + what);
}

void MtgNotes::add(const std::string& what) {
  notes_.push_back(file_ + ": " + what);
}

std::vector<std::string> MtgNotes::take() {
  if (repairs_ > mostRepairs)
    add(std::to_string(repairs_ - mostRepairs) + " more places were repaired");
  return std::exchange(notes_, {});
}

std::string mtgCell(const std::string& file, std::size_t line, std::size_t column) {
  return file + ", line " + std::to_string(line) + ", column " + std::to_string(column + 1) + ": ";
}

} // namespace espalier
