#include "core/mtg/mtg_rows.h"

#include "core/base/shown_message.h"
#include "core/mtg/mtg_lines.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace espalier {
namespace {

constexpr std::size_t mostColumns = 64; // no plant has more

using MaybeVertex = std::optional<VertexId>;

/// What each vertex is attached to in the text.
class Bearers {
public:
  explicit Bearers(const Mtg& mtg) : mtg_(mtg), firstParts_(mtg.vertices.size()) {
    for (std::size_t i = 0; i < mtg.vertices.size(); ++i) {
      const VertexId id{static_cast<std::uint32_t>(i)};
      if (!comesFromOutside(id)) continue;
      const MaybeVertex complex = mtg.vertices[i].complex;
      if (!complex || firstParts_[indexOf(*complex)]) refuse(id);
      firstParts_[indexOf(*complex)] = id;
    }
  }

  /// The vertex that `id` is attached to, none for the scene; by which sign.
  [[nodiscard]] std::pair<MaybeVertex, char> of(VertexId id) const {
    const MtgVertex& vertex = at(id);
    if (!vertex.parent) return {vertex.complex, '/'};
    if (!comesFromOutside(id)) return {entryOf(id), static_cast<char>(vertex.edge)};
    const MtgVertex& complex = at(*vertex.complex);
    if (complex.edge != vertex.edge || !complex.parent ||
        upTo(*vertex.parent, complex.scale) != complex.parent)
      refuse(id);
    return {vertex.complex, '/'};
  }

  [[nodiscard]] bool isFirstPart(VertexId id) const {
    const MaybeVertex complex = at(id).complex;
    return complex && firstParts_[indexOf(*complex)] == id;
  }

private:
  [[nodiscard]] const MtgVertex& at(VertexId id) const { return mtg_.vertices[indexOf(id)]; }

  [[nodiscard]] bool comesFromOutside(VertexId id) const {
    const MtgVertex& vertex = at(id);
    return vertex.parent && at(*vertex.parent).complex != vertex.complex;
  }

  [[nodiscard]] MaybeVertex upTo(MaybeVertex vertex, int scale) const {
    while (vertex && at(*vertex).scale > scale)
      vertex = at(*vertex).complex;
    return vertex;
  }

  /// From which vertex `id` is reached: its parent, or the part of it that the first part of `id`
  /// is attached to.
  [[nodiscard]] VertexId entryOf(VertexId id) const {
    VertexId entry = *at(id).parent;
    for (MaybeVertex part = firstParts_[indexOf(id)]; part; part = firstParts_[indexOf(*part)])
      entry = *at(*part).parent;
    return entry;
  }

  [[noreturn]] void refuse(VertexId id) const {
    const MtgVertex& vertex = at(id);
    throw ShownError(
        {espalier::Shown::tr(
             "the vertex %1 of scale %2 is attached to %3, but what it is a part of "
             "is not attached there: no MTG text can say that; join both to one "
             "unit, or let the unit begin there"),
         {mtgLabel(vertex), std::to_string(vertex.scale), mtgLabel(at(*vertex.parent))}});
  }

  const Mtg& mtg_;
  std::vector<MaybeVertex> firstParts_; // by complex: its part attached to a part of another
};

struct Child {
  VertexId id{};
  char edge = '/';
  bool isFirstPart = false;
};

/// Which of the children of a vertex that stands in `column` continues that column.
///
/// Beyond `mostColumns` it is the one that carries most, so that there are no more columns than
/// these and the logarithm of the vertices: else nested branches make a text of square size.
/// @param weights  by vertex: how many lines it takes, with all that is attached to it
std::size_t continuing(const std::vector<Child>& children, const std::vector<std::size_t>& weights,
                       std::size_t column) {
  const bool hasParts = std::ranges::find(children, '/', &Child::edge) != children.end();
  if (column + 1 >= mostColumns && !hasParts && !children.empty()) {
    const auto heaviest = std::ranges::max_element(
        children, {}, [&](const Child& child) { return weights[indexOf(child.id)]; });
    return static_cast<std::size_t>(heaviest - children.begin());
  }
  for (const char edge : {'<', '/'})
    for (std::size_t i = children.size(); i-- > 0;)
      if (children[i].edge == edge) return i;
  return children.size();
}

class Layout {
public:
  explicit Layout(const Mtg& mtg)
      : children_(mtg.vertices.size()), weights_(mtg.vertices.size(), 1) {
    const Bearers bearers(mtg);
    std::vector<MaybeVertex> bearerOf(mtg.vertices.size());
    for (std::size_t i = 0; i < mtg.vertices.size(); ++i) {
      const VertexId id{static_cast<std::uint32_t>(i)};
      const auto [bearer, edge] = bearers.of(id);
      (bearer ? children_[indexOf(*bearer)] : roots_)
          .push_back({id, edge, bearers.isFirstPart(id)});
      bearerOf[i] = bearer;
    }
    for (std::size_t i = bearerOf.size(); i-- > 0;) // what bears comes first
      if (bearerOf[i]) weights_[indexOf(*bearerOf[i])] += weights_[i];
    // One of a finer scale, read after a coarser one, would be taken for a part of it.
    std::ranges::stable_sort(roots_, std::greater{}, [&](const Child& child) {
      return mtg.vertices[indexOf(child.id)].scale;
    });
  }

  MtgRows rows() {
    for (const Child& root : roots_)
      addFrom(root);
    return std::move(result_);
  }

private:
  void addFrom(const Child& root) {
    std::vector<MtgRow> stack = {{root.id, 0, false, root.edge}};
    while (!stack.empty()) {
      const MtgRow row = stack.back();
      stack.pop_back();
      result_.rows.push_back(row);
      result_.columns = std::max(result_.columns, row.column + 1);
      const std::size_t firstOfChildren = stack.size();
      pushChildren(row, stack);
      std::reverse(stack.begin() + static_cast<std::ptrdiff_t>(firstOfChildren), stack.end());
    }
  }

  /// In the order of their lines.
  void pushChildren(const MtgRow& row, std::vector<MtgRow>& stack) {
    std::vector<Child> children = std::move(children_[indexOf(row.vertex)]);
    std::optional<Child> last;
    const std::size_t which = continuing(children, weights_, row.column);
    if (which < children.size()) {
      last = children[which];
      children.erase(children.begin() + static_cast<std::ptrdiff_t>(which));
    }
    const auto rank = [](const Child& child) {
      return child.edge == '<' ? 0 : child.isFirstPart ? 1 : 2;
    };
    if (last && last->isFirstPart && last->edge == '/' && !children.empty())
      last = swapLast(*last, children);
    std::ranges::stable_sort(children, {}, rank);
    if (std::ranges::count(children, '<', &Child::edge) > 1) result_.isAmbiguous = true;
    for (const Child& child : children)
      stack.push_back({child.id, row.column + 1, false, child.edge});
    if (last) stack.push_back({last->id, row.column, true, last->edge});
  }

  /// The first part must come before the other parts: another of them continues the column.
  static Child swapLast(const Child& last, std::vector<Child>& children) {
    const auto other = std::find_if(children.rbegin(), children.rend(),
                                    [](const Child& child) { return child.edge == '/'; });
    return other == children.rend() ? last : std::exchange(*other, last);
  }

  std::vector<std::vector<Child>> children_; // by vertex
  std::vector<Child> roots_;
  std::vector<std::size_t> weights_; // by vertex
  MtgRows result_;
};

} // namespace

MtgRows mtgRows(const Mtg& mtg) {
  MtgRows result = Layout(mtg).rows();
  if (result.rows.size() != mtg.vertices.size())
    throw ShownError({espalier::Shown::tr(
        "the units of the plant are attached to each other in a ring: no MTG text can say that")});
  return result;
}

} // namespace espalier
