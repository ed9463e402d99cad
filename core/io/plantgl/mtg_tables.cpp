#include "core/io/plantgl/mtg_tables.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"

#include <algorithm>

namespace espalier {
namespace {

constexpr auto globals = std::to_array<PickleGlobal>({{"openalea.mtg.mtg", "MTG"},
                                                      {"openalea.plantgl.math._pglmath", "Vector3"},
                                                      {"openalea.plantgl.math", "Vector3"},
                                                      {"openalea.plantgl._pglmath", "Vector3"},
                                                      {"vplants.plantgl.math._pglmath", "Vector3"},
                                                      {"vplants.plantgl.math", "Vector3"},
                                                      {"vplants.plantgl._pglmath", "Vector3"}});
constexpr std::size_t mtgClass = 0;

/// Walks along the values, and counts its steps: a pickle may share a table with itself.
class Walk {
public:
  Walk(const Pickle& pickle, const std::string& file)
      : pickle_(pickle), file_(file), stepsLeft_(16 * pickle.values.size() + 16) {}

  [[noreturn]] void fail(ShownMessage what) const {
    what.where = FilePlace{file_};
    throw ShownError(std::move(what));
  }

  /// @param ifNone  what is wrong if it is no table
  const PickleDict& dict(PickleId id, ShownMessage ifNone) {
    const auto* found = std::get_if<PickleDict>(&pickle_[id]);
    if (found == nullptr) fail(std::move(ifNone));
    if (found->items.size() > stepsLeft_)
      fail({espalier::Shown::tr("its tables share one another too often: save it as .mtg with the "
                                "program that wrote it")});
    stepsLeft_ -= found->items.size();
    return *found;
  }

  [[nodiscard]] const std::string* text(PickleId id) const {
    return std::get_if<std::string>(&pickle_[id]);
  }

  [[nodiscard]] std::int64_t vertex(PickleId id, std::string_view table) const {
    const auto* number = std::get_if<std::int64_t>(&pickle_[id]);
    if (number == nullptr)
      fail({espalier::Shown::tr("its table %1 has a key that is no number: save it as .mtg with "
                                "the program that wrote it"),
            {std::string(table)}});
    return *number;
  }

  const PickleDict& table(PickleId id, const std::string& name) {
    return dict(id,
                {espalier::Shown::tr(
                     "its table %1 is no table: save it as .mtg with the program that wrote it"),
                 {name}});
  }

  /// A table of numbers; entries that are None are left out.
  MtgTables::ByVertex numbers(PickleId id, const std::string& name) {
    MtgTables::ByVertex numbers;
    for (const auto& [key, value] : table(id, name).items) {
      if (std::holds_alternative<PickleNone>(pickle_[value]))
        numbers.erase(vertex(key, name));
      else
        numbers[vertex(key, name)] = vertex(value, name);
    }
    return numbers;
  }

  std::vector<MtgProperty> properties(PickleId id) {
    std::vector<MtgProperty> properties;
    for (const auto& [key, value] : table(id, "_properties").items) {
      const std::string* name = text(key);
      if (name == nullptr)
        fail({espalier::Shown::tr("it has a property whose name is no text: save it as .mtg with "
                                  "the program that wrote it")});
      MtgProperty property{*name, {}};
      const PickleDict& values =
          dict(value,
               {espalier::Shown::tr(
                    "its property %1 is no table: save it as .mtg with the program that wrote it"),
                {inQuotes(*name)}});
      for (const auto& [vertexId, entry] : values.items)
        property.values.emplace_back(vertex(vertexId, *name), entry);
      properties.push_back(std::move(property));
    }
    return properties;
  }

private:
  const Pickle& pickle_;
  const std::string& file_;
  std::size_t stepsLeft_;
};

std::optional<double> numberOf(const PickleValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::nullopt;
}

} // namespace

std::span<const PickleGlobal> mtgGlobals() {
  return globals;
}

MtgTables mtgTablesIn(const Pickle& pickle, const std::string& file) {
  Walk walk(pickle, file);
  const auto* object = std::get_if<PickleObject>(&pickle[pickle.root]);
  if (object == nullptr || object->global != mtgClass || !object->state)
    walk.fail({espalier::Shown::tr("is a pickle of something else than an MTG: save it as .mtg "
                                   "with the program that wrote it")});
  MtgTables tables;
  bool hasScales = false;
  const PickleDict& state =
      walk.dict(*object->state,
                {espalier::Shown::tr(
                    "its state is no table: save it as .mtg with the program that wrote it")});
  for (const auto& [key, value] : state.items) {
    const std::string* name = walk.text(key);
    if (name == nullptr) continue;
    if (*name == "_scale") tables.scales = walk.numbers(value, *name);
    if (*name == "_parent") tables.parents = walk.numbers(value, *name);
    if (*name == "_complex") tables.complexes = walk.numbers(value, *name);
    if (*name == "_properties") tables.properties = walk.properties(value);
    hasScales = hasScales || *name == "_scale";
  }
  if (!hasScales)
    walk.fail({espalier::Shown::tr(
        "its MTG has no table _scale: save it as .mtg with the program that wrote it")});
  return tables;
}

std::optional<std::array<double, 3>> vectorIn(const Pickle& pickle, PickleId id) {
  const PickleValue* value = &pickle[id];
  if (const auto* object = std::get_if<PickleObject>(value)) {
    if (object->global == mtgClass) return std::nullopt;
    value = &pickle[object->arguments];
  }
  const auto* sequence = std::get_if<PickleSequence>(value);
  if (sequence == nullptr || sequence->kind == PickleSequence::Kind::set ||
      sequence->items.size() != 3)
    return std::nullopt;
  std::array<double, 3> vector{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = numberOf(pickle[sequence->items[i]]);
    if (!number) return std::nullopt;
    vector[i] = *number;
  }
  return vector;
}

} // namespace espalier
