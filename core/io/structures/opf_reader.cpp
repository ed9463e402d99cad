#include "core/base/text.h"
#include "core/io/bytes/xml.h"
#include "core/io/structures/opf.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace espalier {
namespace {

constexpr std::size_t mostRoom = 10'000'000; // for values, those that are empty too
constexpr std::array<const char*, 3> coordinates = {"XX", "YY", "ZZ"};

/// From which vertex, and how, a coarser one was reached: its first part is attached there.
struct Entry {
  VertexId vertex;
  EdgeType edge;
};

/// Reads the vertices of a topology.
class OpfTopology {
public:
  explicit OpfTopology(const XmlFile& xml) : xml_(xml) {
    for (const pugi::xml_node item : xml.root().child("attributeBDD").children("attribute"))
      types_[item.attribute("name").value()] = typeOf(item.attribute("class").value());
    mtg_.classes.push_back({.symbol = "$", .scale = 0, .definition = "IMPLICIT"});
  }

  Imported<Mtg> read() {
    const pugi::xml_node topology = xml_.root().child("topology");
    if (!topology)
      throw ShownError({espalier::Shown::tr("holds no topology"), {}, FilePlace{xml_.file()}});
    addAll(topology);
    if (mtg_.vertices.empty())
      throw ShownError({espalier::Shown::tr("holds no vertices"), {}, FilePlace{xml_.file()}});
    Imported<Mtg> result{std::move(mtg_), {}};
    if (!hasCoordinates_ && placeByGeometry(result.value))
      result.notes.push_back(
          {espalier::Shown::tr("nodes are placed at the upper ends of the shapes of their organs; "
                               "the meshes are left out"),
           {},
           FilePlace{xml_.file()}});
    return result;
  }

private:
  /// An element whose children are yet to be read, and the vertex it stands for; none: the scene.
  struct Step {
    pugi::xml_node element;
    std::optional<VertexId> vertex;
  };

  static std::string typeOf(std::string_view javaClass) {
    if (javaClass == "Integer") return "INT";
    const bool isNumber = javaClass == "Double" || javaClass == "Float" ||
                          javaClass.find("etre") != std::string_view::npos; // Metre, Metre_100 ...
    return isNumber ? "REAL" : "ALPHA";
  }

  static bool isVertex(std::string_view name) {
    return name == "decomp" || name == "follow" || name == "branch";
  }

  /// Not by recursion: a plant is nested as deep as it is tall.
  void addAll(pugi::xml_node topology) {
    std::vector<Step> stack;
    const int scale = scaleOf(topology, 0);
    stack.push_back({topology, scale == 0 ? std::nullopt : std::optional(add(topology, {}))});
    while (!stack.empty()) {
      const Step step = stack.back();
      stack.pop_back();
      std::vector<Step> inner;
      for (const pugi::xml_node child : step.element.children()) {
        if (child.type() != pugi::node_element) continue;
        const std::string_view name = child.name();
        if (isVertex(name))
          inner.push_back({child, add(child, step.vertex)});
        else if (step.vertex && name == "geometry")
          readGeometry(child, *step.vertex);
        else if (step.vertex)
          readFeature(child, *step.vertex);
      }
      stack.insert(stack.end(), inner.rbegin(), inner.rend());
    }
  }

  [[nodiscard]] int scaleOf(pugi::xml_node element, int coarsest) const {
    const std::string_view text = element.attribute("scale").value();
    const double scale = xml_.numberIn(element, text, "scale");
    if (scale < coarsest || scale > finestScale || scale != static_cast<int>(scale))
      throw ShownError({espalier::Shown::tr("expected a scale from %1 to %2, found %3"),
                        {std::to_string(coarsest), std::to_string(finestScale), inQuotes(text)},
                        xml_.where(element)});
    return static_cast<int>(scale);
  }

  VertexId add(pugi::xml_node element, std::optional<VertexId> outer) {
    MtgVertex vertex{.symbol = element.attribute("class").value(), .scale = scaleOf(element, 1)};
    if (vertex.symbol.empty())
      throw ShownError({espalier::Shown::tr("the vertex has no class"), {}, xml_.where(element)});
    addClass(vertex);
    const VertexId id{static_cast<std::uint32_t>(mtg_.vertices.size())};
    const std::string_view link = element.name();
    if (link == "follow" || link == "branch") {
      vertex.edge = link == "branch" ? EdgeType::branching : EdgeType::successor;
      attach(element, vertex, id, outer);
    } else if (outer) {
      becomePart(element, vertex, *outer);
    }
    mtg_.vertices.push_back(std::move(vertex));
    return id;
  }

  void addClass(const MtgVertex& vertex) {
    if (classes_.emplace(vertex.symbol, vertex.scale).second)
      mtg_.classes.push_back(
          {.symbol = vertex.symbol, .scale = vertex.scale, .definition = "EXPLICIT"});
  }

  void attach(pugi::xml_node element, MtgVertex& vertex, VertexId id,
              std::optional<VertexId> outer) {
    const std::optional<VertexId> bearer = outer ? upTo(*outer, vertex.scale) : std::nullopt;
    if (!bearer)
      throw ShownError(
          {espalier::Shown::tr("this vertex of scale %1 is attached to nothing of its scale"),
           {std::to_string(vertex.scale)},
           xml_.where(element)});
    vertex.parent = bearer;
    vertex.complex = mtg_.vertices[indexOf(*bearer)].complex;
    if (bearer != outer) entries_.emplace(id, Entry{*outer, vertex.edge});
  }

  void becomePart(pugi::xml_node element, MtgVertex& vertex, VertexId outer) {
    const int outerScale = mtg_.vertices[indexOf(outer)].scale;
    if (vertex.scale <= outerScale)
      throw ShownError(
          {espalier::Shown::tr("a part of a vertex of scale %1 must have a finer scale, not %2"),
           {std::to_string(outerScale), std::to_string(vertex.scale)},
           xml_.where(element)});
    vertex.complex = outer;
    const auto entry = entries_.find(outer);
    if (entry == entries_.end()) return;
    if (const auto bearer = upTo(entry->second.vertex, vertex.scale)) {
      vertex.parent = bearer;
      vertex.edge = entry->second.edge;
    }
    if (vertex.scale < mtg_.vertices[indexOf(entry->second.vertex)].scale)
      entries_.emplace(VertexId{static_cast<std::uint32_t>(mtg_.vertices.size())}, entry->second);
    entries_.erase(outer); // only its first part is attached there
  }

  /// The vertex itself, or what it is a part of at a coarser scale.
  [[nodiscard]] std::optional<VertexId> upTo(VertexId vertex, int scale) const {
    std::optional<VertexId> at = vertex;
    while (at && mtg_.vertices[indexOf(*at)].scale > scale)
      at = mtg_.vertices[indexOf(*at)].complex;
    if (!at || mtg_.vertices[indexOf(*at)].scale != scale) return std::nullopt;
    return at;
  }

  void setValue(Mtg& mtg, VertexId id, const std::string& feature, const std::string& type,
                std::string text) {
    const auto [place, isNew] = features_.emplace(feature, mtg.features.size());
    if (isNew) mtg.features.push_back({feature, type});
    std::vector<std::string>& values = mtg.vertices[indexOf(id)].values;
    if (place->second >= values.size()) {
      room_ += place->second + 1 - values.size();
      if (room_ > mostRoom)
        throw ShownError(
            {espalier::Shown::tr("has more features, on more vertices, than fit into memory"),
             {},
             FilePlace{xml_.file()}});
      values.resize(place->second + 1);
    }
    values[place->second] = std::move(text);
  }

  void readFeature(pugi::xml_node element, VertexId id) {
    std::string text(trimmed(element.child_value()));
    std::ranges::replace_if(
        text, [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' '); // as in an MTG
    const std::string name = element.name();
    const auto type = types_.find(name);
    if (text.empty()) return;
    const std::string small = lowerCase(name);
    hasCoordinates_ = hasCoordinates_ || small == "xx" || small == "x";
    setValue(mtg_, id, name, type == types_.end() ? "ALPHA" : type->second, std::move(text));
  }

  /// Keeps where a shape ends: the matrix has three rows of four, the last column moves.
  void readGeometry(pugi::xml_node element, VertexId id) {
    const pugi::xml_node matrix = element.child("mat");
    if (!matrix) return;
    std::vector<double> numbers;
    std::string text = matrix.child_value();
    std::ranges::replace(text, '\n', ' ');
    for (std::string_view rest = trimmed(text); !rest.empty() && numbers.size() <= 12;)
      numbers.push_back(xml_.numberIn(matrix, nextWord(rest), "mat"));
    if (numbers.size() != 12)
      throw ShownError({numbers.size() > 12
                            ? espalier::Shown::tr("expected a matrix of 12 numbers, found more")
                            : espalier::Shown::tr("expected a matrix of 12 numbers, found %1"),
                        {std::to_string(numbers.size())},
                        xml_.where(matrix)});
    ends_.emplace_back(id, Eigen::Vector3d(numbers[0] + numbers[3], numbers[4] + numbers[7],
                                           numbers[8] + numbers[11]));
  }

  /// Whether there was any vertex to place.
  bool placeByGeometry(Mtg& mtg) {
    for (const auto& [id, end] : ends_)
      for (std::size_t axis = 0; axis < 3; ++axis)
        setValue(mtg, id, coordinates[axis], "REAL",
                 plainDecimal(end[static_cast<Eigen::Index>(axis)]));
    return !ends_.empty();
  }

  const XmlFile& xml_;
  Mtg mtg_;
  std::map<std::string, std::string> types_; // of features
  std::map<std::string, std::size_t> features_;
  std::set<std::pair<std::string, int>> classes_;
  std::map<VertexId, Entry> entries_; // of vertices that have no parts yet
  std::vector<std::pair<VertexId, Eigen::Vector3d>> ends_;
  std::size_t room_ = 0; // taken by values
  bool hasCoordinates_ = false;
};

} // namespace

bool isOpf(std::string_view beginning) {
  return isXml(beginning, "opf");
}

Imported<Mtg> readOpf(std::istream& in, const std::string& file) {
  const XmlFile xml(readAll(in), file, "opf");
  return OpfTopology(xml).read();
}

} // namespace espalier
