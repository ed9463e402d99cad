#include "core/mtg/mtg_topology.h"

#include "core/base/text.h"

#include <algorithm>
#include <limits>

namespace espalier {
namespace {

constexpr std::string_view edges = "/<+";
constexpr std::string_view signs = "/<+^(";
constexpr std::string_view digits = "0123456789";
constexpr std::string_view indexSigns = "0123456789.";
constexpr std::string_view noIndex = "-9999"; // MultiScaleTreeGraph.jl writes it for none
constexpr std::size_t mostInRanges = 200'000;

/// Whether `text` can name a class: letters, digits, _ and what is not ASCII, no digit first or
/// last.
bool isSymbol(std::string_view text) {
  const auto isLetter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) > 0x7F;
  };
  const auto isPart = [&](char c) {
    return isLetter(c) || c == '_' || digits.find(c) != std::string_view::npos;
  };
  return !text.empty() && text.size() <= 100 && isLetter(text.front()) &&
         std::ranges::all_of(text, isPart);
}

std::string_view withoutIndex(std::string_view text) {
  return text.substr(0, text.find_last_not_of(indexSigns) + 1);
}

bool hasLooseDot(std::string_view index) {
  return index.starts_with('.') || index.ends_with('.') ||
         index.find("..") != std::string_view::npos;
}

/// "P, A, U", the first few of them.
std::string symbolsOf(const std::vector<MtgClass>& classes) {
  constexpr std::size_t most = 12;
  std::string list;
  for (std::size_t i = 0; i < std::min(classes.size(), most); ++i)
    list += (list.empty() ? "" : ", ") + classes[i].symbol;
  return list + (classes.size() > most ? " ..." : "");
}

/// How many steps a range makes that counts up from one index to another: 2 from S16.1 to S16.3.
/// None if it does not.
std::size_t stepsOf(const std::optional<LabelIndex>& from, const std::optional<LabelIndex>& to) {
  if (!from || !to) return 0;
  std::vector<int> first = from->parts();
  std::vector<int> last = to->parts();
  if (first.size() != last.size() || first.back() >= last.back()) return 0;
  const auto steps = static_cast<std::size_t>(last.back()) - static_cast<std::size_t>(first.back());
  first.back() = last.back();
  return first == last ? steps : 0;
}

} // namespace

MtgTopology::MtgTopology(Mtg& mtg, MtgNotes& notes, bool continuesColumns)
    : mtg_(mtg), notes_(notes), continuesColumns_(continuesColumns) {
  int coarsest = std::numeric_limits<int>::max();
  for (const MtgClass& each : mtg.classes) {
    scales_.emplace(each.symbol, each.scale);
    scalesInUse_.insert(each.scale);
    if (each.scale > 0) coarsest = std::min(coarsest, each.scale);
  }
  coarsest_ = coarsest;
}

MtgSpan MtgTopology::add(std::string_view code, MtgPlace place) {
  const bool isDisputed =
      code.starts_with('<') && place.column > 0 && columns_.size() > place.column;
  Path path = pathOf(code, place);
  const std::size_t first = mtg_.vertices.size();
  while (!code.empty())
    follow(nextStep(code, place), path, place);
  if (mtg_.vertices.size() == first)
    fail(place, espalier::Shown::tr("expected /, < or + and a label, as in '^<U2'"));
  if (isDisputed) {
    if (disputed_.empty()) firstDispute_ = place;
    disputed_.push_back(VertexId{static_cast<std::uint32_t>(first)});
  }
  columns_.resize(std::min(columns_.size(), place.column)); // what was attached there is complete
  columns_.push_back(std::move(path.own));
  return path.span;
}

VertexId MtgTopology::lastOf(MtgPlace place) const {
  const auto last = columnAt(place.column, place).last;
  if (!last) fail(place, espalier::Shown::tr("nothing stands above the *"));
  return *last;
}

void MtgTopology::name(const std::string& alias, VertexId vertex, MtgPlace place) {
  if (!aliases_.insert_or_assign(alias, vertex).second)
    notes_.repaired(
        cell(place),
        {espalier::Shown::tr("the alias %1 is given again: from here on it means this vertex"),
         {inQuotes(alias)}});
}

FilePlace MtgTopology::cell(MtgPlace place) const {
  return mtgCell(notes_.file(), place.line, place.column);
}

void MtgTopology::fail(MtgPlace place, const char* sentence,
                       std::vector<std::string> values) const {
  throw ShownError({sentence, std::move(values), cell(place)});
}

MtgTopology::Column MtgTopology::columnAt(std::size_t wanted, MtgPlace place) const {
  if (wanted >= columns_.size())
    fail(place,
         espalier::Shown::tr("this is attached to column %1, where nothing stands before it: move "
                             "it to the left"),
         {std::to_string(wanted + 1)});
  return columns_[wanted];
}

MtgTopology::Path MtgTopology::pathOf(std::string_view& code, MtgPlace place) {
  const bool continues = code.starts_with('^');
  if (continues && code.substr(1).starts_with('(')) code.remove_prefix(1); // the name says it all
  if (code.starts_with('(')) return pathOfName(code, place);
  Path path;
  path.before = anchor(code, place, path.isName);
  if (continues) {
    path.own = path.before;
    code = trimmed(code.substr(1));
  }
  if (code.empty() || edges.find(code.front()) == std::string_view::npos)
    fail(place, espalier::Shown::tr("expected /, < or + before %1"), {inQuotes(code)});
  return path;
}

MtgTopology::Path MtgTopology::pathOfName(std::string_view& code, MtgPlace place) const {
  const std::size_t end = code.find(')');
  if (end == std::string_view::npos)
    fail(place, espalier::Shown::tr("the name in %1 is not closed with )"), {inQuotes(code)});
  const std::string alias(trimmed(code.substr(1, end - 1)));
  const auto found = aliases_.find(alias);
  if (found == aliases_.end())
    fail(place, espalier::Shown::tr("no vertex before is named %1 in the column Alias"),
         {inQuotes(alias)});
  code = trimmed(code.substr(end + 1));
  const Column column{found->second, {{scaleOf(found->second), found->second}}};
  return {.before = column, .own = column, .isName = true, .span = {}};
}

MtgTopology::Column MtgTopology::anchor(std::string_view code, MtgPlace place, bool& isName) {
  if (code.starts_with('^')) return columnAt(place.column, place);
  if (place.column > 0) {
    const bool isBelow = columns_.size() > place.column;
    if (continuesColumns_ && isBelow && code.starts_with('<')) return columns_[place.column];
    return columnAt(place.column - 1, place);
  }
  if (!code.starts_with('/')) return columnAt(0, place);
  const std::string_view first = trimmed(code.substr(1, code.find_first_of(signs, 1) - 1));
  const auto label = knownLabel(first);
  const bool isPlant = columns_.empty() || (label && label->scale <= coarsest_);
  if (!isPlant) return columnAt(0, place);
  isName = true;
  if (!scene_ || !label || label->scale == 0) return {};
  return {scene_, {{0, *scene_}}};
}

MtgTopology::Step MtgTopology::nextStep(std::string_view& code, MtgPlace place) const {
  Step step{.edge = code.front()};
  code.remove_prefix(1);
  if (edges.find(step.edge) == std::string_view::npos)
    fail(place, espalier::Shown::tr("%1 may stand only at the beginning of a code"),
         {inQuotes(std::string(1, step.edge))});
  if (step.edge != '/') {
    step.isShared = code.size() > 1 && code[0] == '.' && code[1] == step.edge;
    step.isRange = step.isShared || code.starts_with(step.edge);
    code.remove_prefix(step.isShared ? 2 : step.isRange ? 1 : 0);
  }
  const std::size_t end = std::min(code.find_first_of(signs), code.size());
  step.label = trimmed(code.substr(0, end));
  code.remove_prefix(end);
  step.isLast = code.empty();
  return step;
}

void MtgTopology::follow(const Step& step, Path& path, MtgPlace place) {
  const Label label = labelOf(step, path.before, place);
  if (step.isRange) {
    path.isName = false;
    followRange(step, label, path, place);
    return;
  }
  const auto found =
      path.isName && !step.isLast && label.index
          ? names_.find({path.before.last, step.edge, label.symbol, label.index->parts()})
          : names_.end();
  path.isName = found != names_.end();
  if (!path.isName) {
    addOne(label, step.edge, path, place);
    return;
  }
  for (Column* column : {&path.before, &path.own})
    this->place(found->second, step.edge, *column);
}

void MtgTopology::followRange(const Step& step, const Label& label, Path& path, MtgPlace place) {
  const auto bearer = bearerOf(label, step.edge, path.before);
  const auto start = upTo(bearer, label.scale);
  const MtgVertex* from = start ? &mtg_.vertices[indexOf(*start)] : nullptr;
  const std::size_t steps =
      from && from->symbol == label.symbol ? stepsOf(from->index, label.index) : 0;
  if (steps == 0) {
    notes_.repaired(cell(place),
                    {espalier::Shown::tr("the range to %1 does not count up from a vertex of its "
                                         "class: taken as a single edge"),
                     {inQuotes(step.label)}});
    addOne(label, step.edge, path, place);
    return;
  }
  inRanges_ += steps;
  if (inRanges_ > mostInRanges)
    fail(place,
         espalier::Shown::tr(
             "the ranges up to %1 stand for more than %2 vertices: correct the index"),
         {inQuotes(step.label), std::to_string(mostInRanges)});
  const bool isOfThisCode = path.hasSpan && start == path.span.last;
  const VertexId first =
      isOfThisCode ? *start : VertexId{static_cast<std::uint32_t>(mtg_.vertices.size())};
  LabelIndex index = *from->index;
  for (std::size_t i = 1; i < steps; ++i) {
    index = *index.next();
    addOne({label.symbol, label.scale, index}, step.edge, path, place);
  }
  addOne(label, step.edge, path, place); // as it is typed
  if (step.isShared) path.span.first = first;
}

void MtgTopology::addOne(const Label& label, char edge, Path& path, MtgPlace place) {
  const VertexId id = attach(label, edge, path.before, place);
  if (label.index)
    names_.try_emplace({path.before.last, edge, label.symbol, label.index->parts()}, id);
  if (label.scale == 0) scene_ = id;
  for (Column* column : {&path.before, &path.own})
    this->place(id, edge, *column);
  path.span = {id, id};
  path.hasSpan = true;
}

std::optional<MtgTopology::Label> MtgTopology::knownLabel(std::string_view text) const {
  if (text.ends_with(noIndex)) text.remove_suffix(noIndex.size());
  // The index is the digits, and dots, at the end; symbols may hold digits too, so the longest
  // symbol wins.
  const std::size_t letters = withoutIndex(text).size();
  const std::size_t longest = std::min<std::size_t>(text.size(), 100);
  for (std::size_t length = longest; length >= std::max<std::size_t>(letters, 1); --length) {
    const auto found = scales_.find(text.substr(0, length));
    if (found == scales_.end()) continue;
    Label label{found->first, found->second, std::nullopt};
    if (length == text.size()) return label;
    label.index = LabelIndex::in(text.substr(length));
    if (label.index) return label;
  }
  return std::nullopt;
}

MtgTopology::Label MtgTopology::labelOf(const Step& step, const Column& before, MtgPlace place) {
  if (const auto known = knownLabel(step.label)) return *known;
  const std::string_view symbol = withoutIndex(step.label);
  const std::string_view index = step.label.substr(symbol.size());
  if (!isSymbol(symbol))
    fail(place,
         espalier::Shown::tr("%1 begins with no symbol of the section CLASSES (%2): type one of "
                             "these, and behind it its index, as in U1 or S16.1"),
         {inQuotes(step.label), inQuotes(symbolsOf(mtg_.classes))});
  if (!index.empty() && !LabelIndex::in(index))
    fail(place,
         hasLooseDot(index)
             ? espalier::Shown::tr("the index in %1 has a dot without a number on both sides: type "
                                   "it as in U16 or U16.1")
             : espalier::Shown::tr("the index in %1 is too large"),
         {inQuotes(step.label)});
  declare(symbol, step, before, place);
  return *knownLabel(step.label);
}

void MtgTopology::declare(std::string_view symbol, const Step& step, const Column& before,
                          MtgPlace place) {
  MtgClass added{.symbol = std::string(symbol)};
  if (!before.last && symbol == "Scene")
    added.scale = 0;
  else if (step.edge == '/')
    added.scale = finerThan(before.last ? scaleOf(*before.last) : 0, place);
  else if (before.last)
    added.scale = scaleOf(*before.last);
  else
    fail(place, espalier::Shown::tr("%1 is of no class, and follows nothing"),
         {inQuotes(step.label)});
  notes_.repaired(cell(place), {espalier::Shown::tr(
                                    "the class %1 is not declared and is taken to be of scale %2"),
                                {inQuotes(symbol), std::to_string(added.scale)}});
  scales_.emplace(added.symbol, added.scale);
  scalesInUse_.insert(added.scale);
  mtg_.classes.push_back(std::move(added));
}

int MtgTopology::finerThan(int scale, MtgPlace place) const {
  const auto finer = scalesInUse_.upper_bound(scale);
  if (finer != scalesInUse_.end()) return *finer;
  if (scale >= finestScale) fail(place, espalier::Shown::tr("there are too many scales"));
  return scale + 1;
}

std::optional<VertexId> MtgTopology::upTo(std::optional<VertexId> vertex, int scale) const {
  while (vertex && scaleOf(*vertex) > scale)
    vertex = mtg_.vertices[indexOf(*vertex)].complex;
  return vertex;
}

void MtgTopology::place(VertexId id, char edge, Column& column) const {
  const int scale = scaleOf(id);
  // What branches off leaves the finer vertex that bears it open for more: "^+B2", "^+B3", "^<S4".
  if (edge != '+')
    column.lastOfScale.erase(column.lastOfScale.upper_bound(scale), column.lastOfScale.end());
  column.lastOfScale[scale] = id;
  column.last = id;
}

std::optional<VertexId> MtgTopology::bearerOf(const Label& label, char edge,
                                              const Column& before) const {
  if (edge == '/' || !before.last) return std::nullopt;
  const VertexId finest = before.lastOfScale.rbegin()->second;
  const VertexId from = edge == '+' && scaleOf(finest) > label.scale ? finest : *before.last;
  const auto peer = upTo(from, label.scale);
  if (peer && scaleOf(*peer) == label.scale) return from;
  const auto found = before.lastOfScale.find(label.scale);
  if (found == before.lastOfScale.end()) return std::nullopt;
  return found->second;
}

VertexId MtgTopology::attach(const Label& label, char edge, const Column& before, MtgPlace place) {
  MtgVertex vertex{.symbol = std::string(label.symbol), .index = label.index, .scale = label.scale};
  const VertexId id{static_cast<std::uint32_t>(mtg_.vertices.size())};
  if (const auto bearer = bearerOf(label, edge, before)) {
    vertex.parent = upTo(bearer, label.scale);
    vertex.edge = EdgeType{edge};
    vertex.complex = mtg_.vertices[indexOf(*vertex.parent)].complex;
    if (bearer != vertex.parent) entries_.insert({id, {*bearer, vertex.edge}});
  } else {
    vertex.complex = upTo(before.last, label.scale - 1);
    if (edge != '/' && !vertex.complex)
      fail(place,
           espalier::Shown::tr("%1 is of scale %2, and nothing stands before it that it could be "
                               "attached to"),
           {inQuotes(label.symbol), std::to_string(label.scale)});
    if (edge != '/')
      notes_.repaired(cell(place), {espalier::Shown::tr(
                                        "no vertex of its scale stands before %1: it is taken as "
                                        "the first part of its unit (/)"),
                                    {inQuotes(edge + std::string(label.symbol))}});
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
  if (!parent || scaleOf(*parent) != part.scale) return;
  part.parent = parent;
  part.edge = entry.edge;
  if (*parent != entry.vertex) entries_.insert({id, entry});
}

} // namespace espalier
