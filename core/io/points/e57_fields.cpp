#include "core/io/points/e57_fields.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/io/bytes/scalar.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <limits>
#include <utility>

namespace espalier {
namespace {

struct RoleName {
  std::string_view name;
  E57Role role;
};

constexpr auto cartesianNames = std::to_array<RoleName>({
    {"cartesianX", E57Role::x},
    {"cartesianY", E57Role::y},
    {"cartesianZ", E57Role::z},
    {"cartesianInvalidState", E57Role::invalidPosition},
});

constexpr auto sphericalNames = std::to_array<RoleName>({
    {"sphericalRange", E57Role::range},
    {"sphericalAzimuth", E57Role::azimuth},
    {"sphericalElevation", E57Role::elevation},
    {"sphericalInvalidState", E57Role::invalidPosition},
});

constexpr auto otherNames = std::to_array<RoleName>({
    {"intensity", E57Role::intensity},
    {"isIntensityInvalid", E57Role::invalidIntensity},
    {"colorRed", E57Role::red},
    {"colorGreen", E57Role::green},
    {"colorBlue", E57Role::blue},
    {"isColorInvalid", E57Role::invalidColor},
});

template <std::size_t size>
E57Role roleIn(const std::array<RoleName, size>& names, std::string_view name) {
  const auto* found = std::ranges::find(names, name, &RoleName::name);
  return found == names.end() ? E57Role::none : found->role;
}

/// The fields themselves: those of structures within structures, too, in the order of the document.
std::vector<pugi::xml_node> leavesOf(pugi::xml_node prototype) {
  std::vector<pugi::xml_node> leaves;
  pugi::xml_node node = prototype.first_child();
  while (node && node != prototype) {
    const std::string_view type = node.attribute("type").value();
    const bool isBranch = type == "Structure" || type == "Vector";
    if (isBranch && node.first_child()) {
      node = node.first_child();
      continue;
    }
    if (node.type() == pugi::node_element && !isBranch) leaves.push_back(node);
    while (node != prototype && !node.next_sibling())
      node = node.parent();
    if (node != prototype) node = node.next_sibling();
  }
  return leaves;
}

bool hasAll(const std::vector<pugi::xml_node>& leaves, std::string_view prefix,
            std::initializer_list<std::string_view> names) {
  return std::ranges::all_of(names, [&](std::string_view name) {
    return std::ranges::any_of(leaves, [&](pugi::xml_node leaf) {
      const std::string_view whole = leaf.name();
      return whole.starts_with(prefix) && whole.substr(prefix.size()) == name;
    });
  });
}

/// The roles of the fields; a second field of a role has none.
std::vector<E57Role> rolesOfLeaves(const XmlFile& xml, pugi::xml_node prototype,
                                   const std::vector<pugi::xml_node>& leaves) {
  const bool isCartesian = hasAll(leaves, "cartesian", {"X", "Y", "Z"});
  if (!isCartesian && !hasAll(leaves, "spherical", {"Range", "Azimuth", "Elevation"}))
    throw ShownError({Shown::tr("its points have neither cartesianX, Y and Z nor sphericalRange, "
                                "Azimuth and Elevation: export them with Cartesian coordinates"),
                      {},
                      xml.where(prototype)});
  std::vector<E57Role> roles;
  std::array<bool, indexOf(E57Role::count)> taken{};
  for (const pugi::xml_node leaf : leaves) {
    E57Role role =
        isCartesian ? roleIn(cartesianNames, leaf.name()) : roleIn(sphericalNames, leaf.name());
    if (role == E57Role::none) role = roleIn(otherNames, leaf.name());
    roles.push_back(std::exchange(taken[indexOf(role)], true) ? E57Role::none : role);
  }
  return roles;
}

std::int64_t integerAttribute(const XmlFile& xml, pugi::xml_node node, const char* name,
                              std::int64_t ifMissing) {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute) return ifMissing;
  const std::string_view text = trimmed(attribute.value());
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size())
    throw ShownError({espalier::Shown::tr("expected an integer of 64 bits as %1, found %2"),
                      {name, inQuotes(attribute.value())},
                      xml.where(node)});
  return value;
}

double numberAttribute(const XmlFile& xml, pugi::xml_node node, const char* name,
                       double ifMissing) {
  const pugi::xml_attribute attribute = node.attribute(name);
  return attribute ? xml.numberIn(node, attribute.value(), name) : ifMissing;
}

E57Field integerField(const XmlFile& xml, pugi::xml_node node, bool isScaled) {
  using Limits = std::numeric_limits<std::int64_t>;
  E57Field field;
  field.kind = E57Field::Kind::integer;
  field.minimum = integerAttribute(xml, node, "minimum", Limits::min());
  const std::int64_t maximum = integerAttribute(xml, node, "maximum", Limits::max());
  if (maximum < field.minimum)
    throw ShownError(
        {Shown::tr("the maximum of %1 is below its minimum: the file is damaged, export it again"),
         {inQuotes(node.name())},
         xml.where(node)});
  const std::uint64_t most =
      static_cast<std::uint64_t>(maximum) - static_cast<std::uint64_t>(field.minimum);
  field.bits = static_cast<unsigned>(std::bit_width(most));
  if (isScaled) {
    field.scale = numberAttribute(xml, node, "scale", 1);
    field.offset = numberAttribute(xml, node, "offset", 0);
  }
  field.limits = E57Limits{field.offset + field.scale * static_cast<double>(field.minimum),
                           field.offset + field.scale * static_cast<double>(maximum)};
  return field;
}

E57Field floatField(pugi::xml_node node) {
  E57Field field;
  if (std::string_view(node.attribute("precision").value()) == "single") {
    field.kind = E57Field::Kind::float32;
    field.bits = 32;
  }
  // Some writers have no numbers here; nothing depends on them but the scale of colors.
  const auto least = numberIn(trimmed(node.attribute("minimum").value()));
  const auto most = numberIn(trimmed(node.attribute("maximum").value()));
  if (least && most) field.limits = E57Limits{*least, *most};
  return field;
}

E57Field fieldOf(const XmlFile& xml, pugi::xml_node node, E57Role role) {
  const std::string_view type = node.attribute("type").value();
  E57Field field;
  if (type == "Float") {
    field = floatField(node);
  } else if (type == "Integer" || type == "ScaledInteger") {
    field = integerField(xml, node, type == "ScaledInteger");
  } else if (type == "String" && role == E57Role::none) {
    field.kind = E57Field::Kind::text;
    field.bits = 0;
  } else {
    throw ShownError(
        {Shown::tr("the field %1 is of type %2, expected Float, Integer or ScaledInteger"),
         {inQuotes(node.name()), inQuotes(type)},
         xml.where(node)});
  }
  field.role = role;
  return field;
}

} // namespace

std::vector<E57Field> e57FieldsOf(const XmlFile& xml, pugi::xml_node prototype) {
  const std::vector<pugi::xml_node> leaves = leavesOf(prototype);
  const std::vector<E57Role> roles = rolesOfLeaves(xml, prototype, leaves);
  std::vector<E57Field> fields;
  fields.reserve(leaves.size());
  for (std::size_t i = 0; i < leaves.size(); ++i)
    fields.push_back(fieldOf(xml, leaves[i], roles[i]));
  return fields;
}

void E57Stream::add(std::string_view piece) {
  if (const std::size_t read = bit_ / 8; 2 * read > bytes_.size()) { // seldom, if much is unread
    bytes_.erase(0, read);
    bit_ %= 8;
  }
  bytes_ += piece;
  bits_ += 8 * piece.size();
}

std::uint64_t E57Stream::ready() const {
  if (field_.bits == 0) return std::numeric_limits<std::uint64_t>::max();
  return (8 * bytes_.size() - bit_) / field_.bits;
}

double E57Stream::next() {
  const std::uint64_t packed = take(field_.bits);
  if (field_.kind == E57Field::Kind::float32)
    return std::bit_cast<float>(static_cast<std::uint32_t>(packed));
  if (field_.kind == E57Field::Kind::float64) return std::bit_cast<double>(packed);
  // The sum wraps around where the minimum is negative.
  const auto value = static_cast<std::int64_t>(static_cast<std::uint64_t>(field_.minimum) + packed);
  return field_.offset + field_.scale * static_cast<double>(value);
}

std::uint64_t E57Stream::take(unsigned bits) {
  constexpr std::size_t longest = 9; // bytes that a value of 64 bits may touch
  if (bits == 0) return 0;
  const std::size_t byte = bit_ / 8;
  if (byte + longest > bytes_.size()) return takeBytewise(bits);
  const std::size_t shift = bit_ % 8;
  std::uint64_t value = valueAt<std::uint64_t>(bytes_.data() + byte) >> shift;
  if (shift > 0)
    value |= std::uint64_t{valueAt<std::uint8_t>(bytes_.data() + byte + 8)} << (64 - shift);
  bit_ += bits;
  return bits == 64 ? value : value & ((std::uint64_t{1} << bits) - 1);
}

std::uint64_t E57Stream::takeBytewise(unsigned bits) {
  std::uint64_t value = 0;
  for (unsigned taken = 0; taken < bits;) {
    const auto shift = static_cast<unsigned>(bit_ % 8);
    const unsigned count = std::min(8 - shift, bits - taken);
    const unsigned byte = valueAt<std::uint8_t>(bytes_.data() + bit_ / 8);
    value |= std::uint64_t{(byte >> shift) & ((1U << count) - 1)} << taken;
    taken += count;
    bit_ += count;
  }
  return value;
}

} // namespace espalier
