#include "core/mtg/mtg_topology.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace espalier {
namespace {

constexpr std::string_view edges = "/<+";

} // namespace

MtgTopology::MtgTopology(Mtg& mtg) : mtg_(mtg) {
  int coarsest = std::numeric_limits<int>::max();
  for (const MtgClass& each : mtg.classes) {
    scales_.emplace(each.symbol, each.scale);
    if (each.scale > 0) coarsest = std::min(coarsest, each.scale);
  }
  coarsest_ = coarsest;
}

VertexId MtgTopology::add(std::string_view code, std::size_t column, const std::string& where) {
  Column before = anchor(code, column, where);
  Column own = code.starts_with('^') ? before : Column{};
  if (code.starts_with('^')) code.remove_prefix(1);
  if (code.empty() || edges.find(code.front()) == std::string_view::npos)
    throw Error(where + "expected /, < or + before " + inQuotes(code));
  while (!code.empty()) {
    const char edge = code.front();
    const std::size_t end = std::min(code.find_first_of("/<+^", 1), code.size());
    if (end < code.size() && code[end] == '^')
      throw Error(where + "^ may stand only at the beginning of a code");
    const std::string_view label = code.substr(1, end - 1);
    const bool isRange = label.empty() || label == ".";
    if (isRange && end < code.size() && code[end] == edge)
      throw Error(where + "ranges such as " + inQuotes(code.substr(0, end + 1)) +
                  " cannot be read: write out each vertex");
    const VertexId id = attach(labelOf(trimmed(label), where), edge, before, where);
    for (Column* each : {&before, &own})
      place(id, edge, *each);
    code.remove_prefix(end);
  }
  columns_.resize(std::min(columns_.size(), column)); // what hung there is complete
  columns_.push_back(own);
  return *own.last;
}

MtgTopology::Label MtgTopology::labelOf(std::string_view text, const std::string& where) const {
  // The index is the digits at the end; symbols may hold digits too, so the longest symbol wins.
  const std::size_t letters = text.find_last_not_of("0123456789") + 1;
  for (std::size_t length = text.size(); length >= std::max<std::size_t>(letters, 1); --length) {
    const auto found = scales_.find(std::string(text.substr(0, length)));
    if (found == scales_.end()) continue;
    Label label{found->first, found->second, std::nullopt};
    if (length == text.size()) return label;
    int index = 0;
    const char* end = text.data() + text.size();
    if (std::from_chars(text.data() + length, end, index).ec != std::errc{})
      throw Error(where + "the index in " + inQuotes(text) + " is too large");
    label.index = index;
    return label;
  }
  throw Error(where + inQuotes(text) + " begins with no symbol of the section CLASSES");
}

MtgTopology::Column MtgTopology::anchor(std::string_view code, std::size_t column,
                                        const std::string& where) const {
  const auto columnAt = [&](std::size_t wanted) {
    if (wanted >= columns_.size())
      throw Error(where + "the code in column " + std::to_string(column + 1) + " hangs on column " +
                  std::to_string(wanted + 1) + ", where nothing stands before it");
    return columns_[wanted];
  };
  if (code.starts_with('^')) return columnAt(column);
  if (column > 0) return columnAt(column - 1);
  if (!code.starts_with('/')) return columnAt(0);
  const std::string_view first = code.substr(1, code.find_first_of("/<+^", 1) - 1);
  const bool isPlant = columns_.empty() || labelOf(trimmed(first), where).scale <= coarsest_;
  return isPlant ? Column{} : columnAt(0);
}

std::optional<VertexId> MtgTopology::upTo(std::optional<VertexId> vertex, int scale) const {
  while (vertex && mtg_.vertices[indexOf(*vertex)].scale > scale)
    vertex = mtg_.vertices[indexOf(*vertex)].complex;
  return vertex;
}

void MtgTopology::place(VertexId id, char edge, Column& column) const {
  const int scale = mtg_.vertices[indexOf(id)].scale;
  // What branches off leaves the finer vertex that bears it open for more: "^+B2", "^+B3", "^<S4".
  if (edge != '+')
    column.lastOfScale.erase(column.lastOfScale.upper_bound(scale), column.lastOfScale.end());
  column.lastOfScale[scale] = id;
  column.last = id;
}

std::optional<VertexId> MtgTopology::bearerOf(const Label& label, char edge,
                                              const Column& before) const {
  if (edge == '/' || !before.last) return std::nullopt;
  const auto scaleOf = [&](VertexId id) { return mtg_.vertices[indexOf(id)].scale; };
  const VertexId finest = before.lastOfScale.rbegin()->second;
  const VertexId from = edge == '+' && scaleOf(finest) > label.scale ? finest : *before.last;
  const auto peer = upTo(from, label.scale);
  if (peer && scaleOf(*peer) == label.scale) return from;
  const auto found = before.lastOfScale.find(label.scale);
  if (found == before.lastOfScale.end()) return std::nullopt;
  return found->second;
}

VertexId MtgTopology::attach(const Label& label, char edge, const Column& before,
                             const std::string& where) {
  MtgVertex vertex{.symbol = label.symbol, .index = label.index, .scale = label.scale};
  const VertexId id{static_cast<std::uint32_t>(mtg_.vertices.size())};
  if (const auto bearer = bearerOf(label, edge, before)) {
    vertex.parent = upTo(bearer, label.scale);
    vertex.edge = EdgeType{edge};
    vertex.complex = mtg_.vertices[indexOf(*vertex.parent)].complex;
    if (bearer != vertex.parent) entries_.insert({id, {*bearer, vertex.edge}});
  } else {
    vertex.complex = upTo(before.last, label.scale - 1);
    if (edge != '/' && !vertex.complex)
      throw Error(where + inQuotes(label.symbol) + " is of scale " + std::to_string(label.scale) +
                  ", and nothing stands before it that it could hang on");
    if (vertex.complex) linkFirstPart(vertex, id);
  }
  mtg_.vertices.push_back(std::move(vertex));
  return id;
}

void MtgTopology::linkFirstPart(MtgVertex& part, VertexId id) {
  const auto found = entries_.extract(*part.complex);
  if (!found) return;
  const Entry entry = found.mapped();
  const auto parent = upTo(entry.vertex, part.scale);
  if (!parent || mtg_.vertices[indexOf(*parent)].scale != part.scale) return;
  part.parent = parent;
  part.edge = entry.edge;
  if (*parent != entry.vertex) entries_.insert({id, entry});
}

} // namespace espalier
