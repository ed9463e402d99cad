#include "tests/support/random_edits.h"

namespace espalier::test {

void editAtRandom(SkeletonEditor& editor, Random& random) {
  const std::vector<NodeId> ids = editor.skeleton().ids();
  if (ids.size() < 5) {
    editor.add({.position = random.direction(), .radius = 0.1});
    return;
  }
  const NodeId id = ids[random.below(ids.size())];
  const NodeId other = ids[random.below(ids.size())];
  switch (random.below(10)) {
  case 0:
    editor.setPosition(id, random.direction());
    break;
  case 1:
    editor.setRadius(id, random.uniform());
    break;
  case 2:
    editor.setEdge(id, EdgeType::branching);
    break;
  case 3:
    editor.add({.position = random.direction(), .parent = id, .edge = EdgeType::branching});
    break;
  case 4:
    editor.makeRoot(id);
    break;
  case 5:
    if (editor.skeleton().children(id).empty()) editor.erase(id);
    break;
  case 6:
    editor.setEntities(id, {{.scale = 3,
                             .symbol = "U",
                             .index = static_cast<int>(random.below(5)),
                             .values = {{"Date", "1"}}}});
    break;
  case 7:
    editor.setMarked(id, !editor.skeleton()[id].isMarked);
    break;
  case 8:
    editor.setReview(id, {static_cast<ReviewState>(random.below(3)), "seen", "Anna"});
    break;
  default:
    if (!editor.skeleton().isAncestor(id, other)) editor.reparent(id, other, EdgeType::successor);
  }
}

} // namespace espalier::test
