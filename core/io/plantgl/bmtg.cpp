#include "core/io/plantgl/bmtg.h"

#include "core/base/text.h"
#include "core/io/plantgl/mtg_tables.h"
#include "core/io/plantgl/mtg_vertices.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace espalier {
namespace {

constexpr std::size_t mostFeatures = 256;
constexpr std::size_t longestName = 100;

/// How the values of a property are written.
enum class Form : std::uint8_t { none, integer, real, text, vector };

Form formOf(const Pickle& pickle, PickleId id) {
  const PickleValue& value = pickle[id];
  if (std::holds_alternative<std::int64_t>(value)) return Form::integer;
  if (std::holds_alternative<double>(value)) return Form::real;
  if (std::holds_alternative<bool>(value) || std::holds_alternative<std::string>(value))
    return Form::text;
  return vectorIn(pickle, id) ? Form::vector : Form::none;
}

std::string typeOf(Form form) {
  return form == Form::integer ? "INT" : form == Form::text ? "ALPHA" : "REAL";
}

/// Whether a line of an MTG text, with its columns parted by tabs, can hold this.
bool isWritable(std::string_view text) {
  return std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

/// Puts properties into the vertices as features.
class Features {
public:
  Features(const Pickle& pickle, std::size_t bytes, TableVertices& vertices,
           const std::string& file)
      : pickle_(pickle), vertices_(vertices), file_(file), textLeft_(16 * bytes + (1U << 20)),
        slotsLeft_(64 * pickle.values.size() + (1U << 16)) {}

  /// Property `position` comes first, radius second, the others in their order.
  void add(const std::vector<MtgProperty>& properties) {
    for (const std::string_view first : {"position", "radius"})
      for (const MtgProperty& property : properties)
        if (property.name == first) add(property);
    for (const MtgProperty& property : properties)
      if (property.name != "position" && property.name != "radius") add(property);
    if (leftOut_ > 0)
      note({leftOut_ == 1
                ? espalier::Shown::tr(
                      "1 value is not finite, or of a kind that an MTG cannot hold: left out")
                : espalier::Shown::tr(
                      "%1 values are not finite, or of a kind that an MTG cannot hold: left out"),
            {std::to_string(leftOut_)}});
    if (strays_ > 0)
      note({strays_ == 1
                ? espalier::Shown::tr("1 value is of vertices that were erased: left out")
                : espalier::Shown::tr("%1 values are of vertices that were erased: left out"),
            {std::to_string(strays_)}});
  }

private:
  void note(ShownMessage what) {
    what.where = FilePlace{file_};
    vertices_.notes.push_back(std::move(what));
  }

  void add(const MtgProperty& property) {
    std::map<VertexId, PickleId> values;
    for (const auto& [number, value] : property.values) {
      const auto id = vertices_.ids.find(number);
      if (id == vertices_.ids.end())
        ++strays_;
      else
        values[id->second] = value;
    }
    if (property.name == "edge_type" || property.name == "label") return;
    const Form form = commonForm(values);
    if (form == Form::none) return;
    const std::size_t first = vertices_.mtg.features.size();
    if (!declare(property.name, form)) return;
    for (const auto& [vertex, value] : values)
      set(vertex, first, form, value);
  }

  /// How all values that can be held are written: as vectors if any is one.
  [[nodiscard]] Form commonForm(const std::map<VertexId, PickleId>& values) const {
    Form form = Form::none;
    for (const auto& [vertex, value] : values)
      form = std::max(form, formOf(pickle_, value));
    return form;
  }

  bool declare(const std::string& name, Form form) {
    std::vector<std::string> names = {name};
    if (form == Form::vector)
      names = name == "position" ? std::vector<std::string>{"XX", "YY", "ZZ"}
                                 : std::vector<std::string>{name + "_x", name + "_y", name + "_z"};
    std::vector<MtgFeature>& features = vertices_.mtg.features;
    const auto isTaken = [&](const std::string& candidate) {
      return std::ranges::any_of(features, [&](const MtgFeature& feature) {
        return lowerCase(feature.name) == lowerCase(candidate);
      });
    };
    const bool isName = !name.empty() && name.size() <= longestName && isWritable(name) &&
                        name.find(' ') == std::string::npos;
    if (!isName || std::ranges::any_of(names, isTaken) ||
        features.size() + names.size() > mostFeatures) {
      note({espalier::Shown::tr(
                "property %1 is left out: its name cannot be that of a feature, or is taken"),
            {inQuotes(name)}});
      return false;
    }
    for (const std::string& one : names)
      features.push_back({one, typeOf(form)});
    return true;
  }

  void set(VertexId vertex, std::size_t feature, Form form, PickleId value) {
    if (std::holds_alternative<PickleNone>(pickle_[value])) return;
    if (form == Form::vector) {
      const auto vector = vectorIn(pickle_, value);
      if (!vector || !std::ranges::all_of(*vector, [](double x) { return std::isfinite(x); })) {
        ++leftOut_;
        return;
      }
      for (std::size_t axis = 0; axis < 3; ++axis)
        write(vertex, feature + axis, plainDecimal((*vector)[axis]));
    } else if (const auto text = textOf(pickle_[value])) {
      write(vertex, feature, *text);
    } else {
      ++leftOut_;
    }
  }

  static std::optional<std::string> textOf(const PickleValue& value) {
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
    if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "True" : "False";
    if (const auto* real = std::get_if<double>(&value))
      return std::isfinite(*real) ? std::optional(plainDecimal(*real)) : std::nullopt;
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr || !isWritable(*text)) return std::nullopt;
    return std::string(trimmed(*text));
  }

  void write(VertexId vertex, std::size_t feature, const std::string& text) {
    std::vector<std::string>& values = vertices_.mtg.vertices[indexOf(vertex)].values;
    const std::size_t slots = feature + 1 > values.size() ? feature + 1 - values.size() : 0;
    if (slots > slotsLeft_ || text.size() > textLeft_)
      throw ShownError(
          {espalier::Shown::tr("its values would take far more memory than the file itself: save "
                               "it as .mtg with the program that wrote it"),
           {},
           FilePlace{file_}});
    slotsLeft_ -= slots;
    textLeft_ -= text.size();
    if (slots > 0) values.resize(feature + 1);
    values[feature] = text;
  }

  const Pickle& pickle_;
  TableVertices& vertices_;
  const std::string& file_;
  std::size_t textLeft_;  // a pickle may share one text among all vertices
  std::size_t slotsLeft_; // vertices keep a place for each feature before their last
  std::size_t strays_ = 0;
  std::size_t leftOut_ = 0;
};

/// Nodes at the place of their parent, by the features XX, YY and ZZ.
std::size_t zeroLengthEdges(const Mtg& mtg) {
  if (mtg.features.empty() || mtg.features.front().name != "XX") return 0;
  const auto placeOf = [](const MtgVertex& vertex) {
    return vertex.values.size() < 3
               ? std::vector<std::string>()
               : std::vector<std::string>(vertex.values.begin(), vertex.values.begin() + 3);
  };
  std::size_t count = 0;
  for (const MtgVertex& vertex : mtg.vertices) {
    if (!vertex.parent) continue;
    const std::vector<std::string> place = placeOf(vertex);
    if (!place.empty() && !place.front().empty() &&
        place == placeOf(mtg.vertices[indexOf(*vertex.parent)]))
      ++count;
  }
  return count;
}

} // namespace

bool isBmtg(std::string_view beginning) {
  return beginning.starts_with('\x80') && beginning.find("openalea.mtg") != std::string_view::npos;
}

Imported<Mtg> readBmtg(std::istream& in, const std::string& file) {
  const std::string bytes = readAll(in);
  const Pickle pickle = readPickle(bytes, mtgGlobals(), file);
  const MtgTables tables = mtgTablesIn(pickle, file);
  TableVertices vertices = verticesOf(pickle, tables, file);
  Features(pickle, bytes.size(), vertices, file).add(tables.properties);
  if (const std::size_t count = zeroLengthEdges(vertices.mtg); count > 0)
    vertices.notes.push_back(
        {count == 1
             ? espalier::Shown::tr("1 vertex lies where its parent lies, and is kept so")
             : espalier::Shown::tr("%1 vertices lie where their parents lie, and are kept so"),
         {std::to_string(count)},
         FilePlace{file}});
  return {std::move(vertices.mtg), std::move(vertices.notes)};
}

} // namespace espalier
