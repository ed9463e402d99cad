#include "core/mtg/mtg_notes.h"

#include <utility>

namespace espalier {
namespace {

constexpr std::size_t mostRepairs = 20;

} // namespace

MtgNotes::MtgNotes(std::string file, bool isStrict) : file_(std::move(file)), isStrict_(isStrict) {}

void MtgNotes::repaired(const FilePlace& where, ShownMessage what) {
  what.where = where;
  if (isStrict_) throw ShownError(std::move(what));
  if (++repairs_ <= mostRepairs) notes_.push_back(std::move(what));
}

void MtgNotes::add(ShownMessage what) {
  what.where = FilePlace{file_};
  notes_.push_back(std::move(what));
}

std::vector<ShownMessage> MtgNotes::take() {
  if (repairs_ > mostRepairs) {
    const std::size_t others = repairs_ - mostRepairs;
    add({others == 1 ? espalier::Shown::tr("1 more place was repaired")
                     : espalier::Shown::tr("%1 more places were repaired"),
         {std::to_string(others)}});
  }
  return std::exchange(notes_, {});
}

FilePlace mtgCell(const std::string& file, std::size_t line, std::size_t column) {
  return {.file = file, .line = line, .column = column + 1};
}

} // namespace espalier
