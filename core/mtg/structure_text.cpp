#include "core/mtg/structure_text.h"

#include "core/mtg/mtg_edits.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/mtg_text_edit.h"
#include "core/mtg/mtg_writer.h"

#include <sstream>
#include <utility>

namespace espalier {
namespace {

std::string textOf(const Mtg& mtg) {
  std::ostringstream out;
  writeMtg(out, mtg);
  return std::move(out).str();
}

} // namespace

Imported<Structure> structureOf(MtgFrame frame, std::vector<ShownMessage> notes,
                                const std::string& file) {
  auto kept = std::make_shared<const MtgFrame>(std::move(frame));
  if (!hasPositions(kept->mtg, file)) {
    notes.push_back({espalier::Shown::tr("has no positions: it is a plant without its shape"),
                     {},
                     FilePlace{file}});
    return {{{}, std::move(kept)}, std::move(notes)};
  }
  Imported<Skeleton> skeleton = skeletonOf(kept->mtg, file);
  notes.insert(notes.end(), skeleton.notes.begin(), skeleton.notes.end());
  return {{std::move(skeleton.value), std::move(kept)}, std::move(notes)};
}

std::string mtgTextOf(const Structure& structure, MtgStyle style) {
  if (!structure.frame || (structure.skeleton.isEmpty() && !isWithoutPositions(structure)))
    return textOf(mtgOf(structure.skeleton, style));
  const Mtg edited = withEdits(structure.frame->mtg, structure.skeleton);
  const std::string& text = structure.frame->text;
  return text.empty() ? textOf(edited) : mtgTextWith(text, edited);
}

} // namespace espalier
