#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace espalier {

enum class PickleId : std::uint32_t {}; // place in Pickle::values

[[nodiscard]] constexpr std::size_t indexOf(PickleId id) {
  return static_cast<std::size_t>(id);
}

/// A name that a pickle may mention. Nothing of that name is ever looked up or called.
struct PickleGlobal {
  std::string_view module;
  std::string_view name;
};

struct PickleNone {};

struct PickleSequence {
  enum class Kind : std::uint8_t { list, tuple, set };
  Kind kind = Kind::list;
  std::vector<PickleId> items;
};

struct PickleDict {
  std::vector<std::pair<PickleId, PickleId>> items; // in order; of equal keys the last counts
};

struct PickleName {
  std::size_t global = 0; // place among the globals allowed
};

/// A stand-in for an object: what it was to be made of.
struct PickleObject {
  std::size_t global = 0;        // of its class: place among the globals allowed
  PickleId arguments{};          // a tuple
  std::optional<PickleId> state; // what BUILD was to set
};

/// Text of Python is UTF-8 or bytes of an unknown encoding.
using PickleValue = std::variant<PickleNone, bool, std::int64_t, double, std::string,
                                 PickleSequence, PickleDict, PickleName, PickleObject>;

/// A Python pickle as plain data. Values are shared by their ids as the pickle shares them, and may
/// contain themselves: who walks along them must mind both.
struct Pickle {
  std::vector<PickleValue> values; // by PickleId
  PickleId root{};

  [[nodiscard]] const PickleValue& operator[](PickleId id) const { return values[indexOf(id)]; }
};

/// Reads a pickle of protocols 0 to 5 with a machine that knows plain data only.
///
/// Numbers, text, lists, tuples, sets and dicts become values; a class or function of `allowed` a
/// PickleName, and an instance of it a PickleObject, by which nothing is made or called. Whatever
/// else a pickle could do is refused: other names, extension codes, persistent ids, out-of-band
/// buffers, instances by INST, OBJ or NEWOBJ_EX, integers of more than 64 bits. What follows the
/// end of the pickle is passed over.
///
/// @param file  its name, for messages
/// @throws Error naming the byte, the opcode and, where it asks for one, the name
/// Time and memory O(bytes): nothing is taken by a size stated in the file before that is there,
/// and values lie flat, so that depth costs no stack.
/// Specification: Python's Lib/pickletools.py, which defines the opcodes of all protocols.
[[nodiscard]] Pickle readPickle(std::string_view bytes, std::span<const PickleGlobal> allowed,
                                const std::string& file);

} // namespace espalier
