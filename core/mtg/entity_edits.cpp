#include "core/mtg/entity_edits.h"

#include "core/base/shown_message.h"
#include "core/mtg/unit_edits.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace espalier {

void changeEntity(SkeletonEditor& editor, NodeId id, int scale,
                  const std::function<void(Entity&)>& change) {
  std::vector<Entity> entities = editor.skeleton()[id].entities;
  if (entities.empty()) entities.push_back(ownEntity(editor.skeleton(), id));
  const auto at = std::ranges::find(entities, scale, &Entity::scale);
  if (at == entities.end())
    throw ShownError(
        {Shown::tr("nothing of scale %1 begins at node %2: choose the node it begins at"),
         {std::to_string(scale), std::to_string(indexOf(id))}});
  change(*at);
  editor.setEntities(id, std::move(entities));
}

} // namespace espalier
