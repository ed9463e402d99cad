#include "core/evaluate/traits/strahler.h"

#include <algorithm>
#include <optional>

namespace espalier {

std::vector<int> strahlerNumbers(const Skeleton& skeleton) {
  std::vector<int> numbers(skeleton.idEnd(), 0);
  const std::vector<NodeId> ids = skeleton.ids();
  for (std::size_t i = ids.size(); i-- > 0;) { // children first
    const NodeId id = ids[i];
    int most = 1;
    int several = 0;
    for (const NodeId child : skeleton.children(id)) {
      const int number = numbers[indexOf(child)];
      if (number > most) several = 0;
      most = std::max(most, number);
      if (number == most) ++several;
    }
    numbers[indexOf(id)] = several > 1 ? most + 1 : most;
  }
  return numbers;
}

std::vector<StrahlerOrder> strahlerOrders(const Skeleton& skeleton) {
  const std::vector<int> numbers = strahlerNumbers(skeleton);
  std::vector<StrahlerOrder> orders;
  for (const NodeId id : skeleton.ids()) {
    const auto number = static_cast<std::size_t>(numbers[indexOf(id)]);
    if (number > orders.size()) orders.resize(number);
    StrahlerOrder& order = orders[number - 1];
    const std::optional<NodeId> parent = skeleton[id].parent;
    if (!parent || numbers[indexOf(*parent)] != numbers[indexOf(id)]) ++order.streams;
    if (parent) order.length += (skeleton[id].position - skeleton[*parent].position).norm();
  }
  return orders;
}

} // namespace espalier
