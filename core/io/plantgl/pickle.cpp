#include "core/io/plantgl/pickle.h"

#include "core/base/text.h"
#include "core/io/bytes/byte_reader.h"
#include "core/io/plantgl/pickle_text.h"

#include <limits>
#include <map>
#include <type_traits>

namespace espalier {
namespace {

using Kind = PickleSequence::Kind;
constexpr int newestProtocol = 5;

/// Runs a pickle. The stack, the marks in it and the memo are those of pickletools.
class Machine {
public:
  Machine(std::string_view bytes, std::span<const PickleGlobal> allowed, const std::string& file)
      : in_(bytes, file), allowed_(allowed) {}

  Pickle run() {
    while (!isDone_) {
      start_ = in_.offset();
      opcode_ = in_.value<std::uint8_t>();
      if (!runNumber() && !runText() && !runContainer() && !runStack() && !runObject()) refuse();
    }
    return std::move(pickle_);
  }

private:
  /// @param sentence  with %1 for the opcode, then %2 ... for the values
  [[noreturn]] void fail(const char* sentence, std::vector<std::string> values = {}) const {
    values.insert(values.begin(), nameOfPickleOpcode(opcode_));
    in_.failAt(start_, {sentence, std::move(values)});
  }
  [[noreturn]] void refuse() const {
    fail(espalier::Shown::tr(
        "opcode %1 is not plain data, and this file may be meant to do harm: it is not read. If "
        "you trust it, save it as .mtg with the program that wrote it"));
  }

  PickleId pop() {
    const PickleId taken = top();
    stack_.pop_back();
    return taken;
  }
  [[nodiscard]] std::size_t base() const { return marks_.empty() ? 0 : marks_.back(); }
  std::vector<PickleId> popToMark() {
    if (marks_.empty()) fail(espalier::Shown::tr("opcode %1 finds no mark: the file is damaged"));
    const auto begin = stack_.begin() + static_cast<std::ptrdiff_t>(marks_.back());
    std::vector<PickleId> items(begin, stack_.end());
    stack_.erase(begin, stack_.end());
    marks_.pop_back();
    return items;
  }
  [[nodiscard]] PickleId top() const {
    if (stack_.size() <= base())
      fail(espalier::Shown::tr("opcode %1 finds nothing to work on: the file is damaged"));
    return stack_.back();
  }

  bool push(PickleValue value) {
    if (pickle_.values.size() >= std::numeric_limits<std::uint32_t>::max())
      fail(espalier::Shown::tr("opcode %1 comes after more values than can be counted"));
    const PickleId id{static_cast<std::uint32_t>(pickle_.values.size())};
    pickle_.values.push_back(std::move(value));
    stack_.push_back(id);
    return true;
  }
  bool push(Kind kind, std::vector<PickleId> items) {
    return push(PickleSequence{kind, std::move(items)});
  }
  /// @param ifNone  what is wrong if it is none, as of fail()
  template <class T> T& valueOf(PickleId id, const char* ifNone) {
    T* value = std::get_if<T>(&pickle_.values[indexOf(id)]);
    if (value == nullptr) fail(ifNone);
    return *value;
  }
  template <class Size> std::string sized() {
    const auto size = in_.value<Size>();
    if constexpr (std::is_signed_v<Size>)
      if (size < 0) fail(espalier::Shown::tr("opcode %1 has a text of negative length"));
    return std::string(in_.take(static_cast<std::uint64_t>(size)));
  }

  bool runNumber();
  bool runText();
  bool runContainer();
  bool runStack();
  bool runObject();
  bool pushLong(std::string_view digits);
  bool pushInteger(std::string_view text, bool mayBeTruth);
  bool extend(Kind kind, const std::vector<PickleId>& items);
  bool setItems(PickleId dict, const std::vector<PickleId>& items);
  bool get(std::uint64_t slot);
  std::uint64_t slotIn(std::string_view line);
  bool pushName(std::string_view module, std::string_view name);
  bool make();
  bool build();

  ByteReader in_;
  std::span<const PickleGlobal> allowed_;
  Pickle pickle_;
  std::vector<PickleId> stack_;
  std::vector<std::size_t> marks_; // heights of the stack
  std::map<std::uint64_t, PickleId> memo_;
  std::size_t start_ = 0; // byte of the opcode
  std::uint8_t opcode_ = 0;
  bool isDone_ = false;
};

bool Machine::runNumber() {
  switch (opcode_) {
  case 'N':
    return push(PickleNone{});
  case 0x88:
    return push(true);
  case 0x89:
    return push(false);
  case 'J':
    return push(std::int64_t{in_.value<std::int32_t>()});
  case 'K':
    return push(std::int64_t{in_.value<std::uint8_t>()});
  case 'M':
    return push(std::int64_t{in_.value<std::uint16_t>()});
  case 'I':
    return pushInteger(in_.takeUntil('\n'), true);
  case 'L':
    return pushInteger(in_.takeUntil('\n'), false);
  case 0x8a:
    return pushLong(in_.take(in_.value<std::uint8_t>()));
  case 0x8b:
    return pushLong(sized<std::int32_t>());
  case 'G':
    return push(in_.value<double>(std::endian::big));
  case 'F': {
    const std::string_view line = in_.takeUntil('\n');
    const auto number = numberIn(line);
    if (!number) fail(espalier::Shown::tr("opcode %1 has %2, expected a number"), {inQuotes(line)});
    return push(*number);
  }
  default:
    return false;
  }
}

/// Little-endian, two's complement.
bool Machine::pushLong(std::string_view digits) {
  if (digits.size() > 8) fail(espalier::Shown::tr("opcode %1 has an integer of more than 64 bits"));
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < digits.size(); ++i)
    value |= std::uint64_t{static_cast<std::uint8_t>(digits[i])} << (8 * i);
  const bool isNegative = !digits.empty() && (static_cast<std::uint8_t>(digits.back()) & 0x80) != 0;
  if (isNegative && digits.size() < 8) value |= ~std::uint64_t{0} << (8 * digits.size());
  return push(static_cast<std::int64_t>(value));
}

bool Machine::pushInteger(std::string_view text, bool mayBeTruth) {
  if (mayBeTruth && (text == "00" || text == "01")) return push(text == "01");
  const auto value = integerInPickle(text);
  if (!value)
    fail(espalier::Shown::tr("opcode %1 has %2, expected an integer of up to 64 bits"),
         {inQuotes(text)});
  return push(*value);
}

bool Machine::runText() {
  switch (opcode_) {
  case 'S': {
    const std::string_view line = in_.takeUntil('\n');
    auto text = textOfQuoted(line);
    if (!text)
      fail(espalier::Shown::tr("opcode %1 has %2, expected a text in quotes"), {inQuotes(line)});
    return push(std::move(*text));
  }
  case 'V':
    return push(textOfRawUnicode(in_.takeUntil('\n')));
  case 'T':
    return push(sized<std::int32_t>());
  case 'U':
  case 'C':
  case 0x8c:
    return push(sized<std::uint8_t>());
  case 'X':
  case 'B':
    return push(sized<std::uint32_t>());
  case 0x8d:
  case 0x8e:
  case 0x96:
    return push(sized<std::uint64_t>());
  default:
    return false;
  }
}

bool Machine::runContainer() {
  switch (opcode_) {
  case ']':
    return push(Kind::list, {});
  case ')':
    return push(Kind::tuple, {});
  case 0x8f:
    return push(Kind::set, {});
  case '}':
    return push(PickleDict{});
  case 'l':
    return push(Kind::list, popToMark());
  case 't':
    return push(Kind::tuple, popToMark());
  case 0x91:
    return push(Kind::set, popToMark());
  case 'd': {
    const std::vector<PickleId> items = popToMark();
    push(PickleDict{});
    return setItems(top(), items);
  }
  case 0x85:
  case 0x86:
  case 0x87: {
    std::vector<PickleId> items(opcode_ - 0x84U);
    for (std::size_t i = items.size(); i > 0; --i)
      items[i - 1] = pop();
    return push(Kind::tuple, std::move(items));
  }
  case 'a':
    return extend(Kind::list, {pop()});
  case 'e':
    return extend(Kind::list, popToMark());
  case 0x90:
    return extend(Kind::set, popToMark());
  case 's': {
    const PickleId value = pop();
    const PickleId key = pop();
    return setItems(top(), {key, value});
  }
  case 'u': {
    const std::vector<PickleId> items = popToMark();
    return setItems(top(), items);
  }
  default:
    return false;
  }
}

bool Machine::extend(Kind kind, const std::vector<PickleId>& items) {
  constexpr auto ifNone =
      espalier::Shown::tr("opcode %1 does not find a list or set to add to: the file is damaged");
  auto& sequence = valueOf<PickleSequence>(top(), ifNone);
  if (sequence.kind != kind) fail(ifNone);
  sequence.items.insert(sequence.items.end(), items.begin(), items.end());
  return true;
}

bool Machine::setItems(PickleId dict, const std::vector<PickleId>& items) {
  auto& target = valueOf<PickleDict>(
      dict, espalier::Shown::tr("opcode %1 does not find a dict to add to: the file is damaged"));
  if (items.size() % 2 != 0)
    fail(espalier::Shown::tr("opcode %1 has a key without a value: the file is damaged"));
  for (std::size_t i = 0; i < items.size(); i += 2)
    target.items.emplace_back(items[i], items[i + 1]);
  return true;
}

bool Machine::runStack() {
  switch (opcode_) {
  case 0x80: {
    const int protocol = in_.value<std::uint8_t>();
    if (protocol > newestProtocol)
      fail(espalier::Shown::tr("opcode %1 asks for protocol %2, and 0 to %3 can be read: save it "
                               "with an older protocol"),
           {std::to_string(protocol), std::to_string(newestProtocol)});
    return true;
  }
  case 0x95: // the length of what comes, for readers that buffer
    (void)in_.take(sizeof(std::uint64_t));
    return true;
  case '(':
    marks_.push_back(stack_.size());
    return true;
  case '0':
    if (stack_.size() == base() && !marks_.empty())
      marks_.pop_back();
    else
      (void)pop();
    return true;
  case '1':
    (void)popToMark();
    return true;
  case '2':
    stack_.push_back(top());
    return true;
  case 'p':
    memo_[slotIn(in_.takeUntil('\n'))] = top();
    return true;
  case 'q':
    memo_[in_.value<std::uint8_t>()] = top();
    return true;
  case 'r':
    memo_[in_.value<std::uint32_t>()] = top();
    return true;
  case 0x94:
    memo_[memo_.size()] = top();
    return true;
  case 'g':
    return get(slotIn(in_.takeUntil('\n')));
  case 'h':
    return get(in_.value<std::uint8_t>());
  case 'j':
    return get(in_.value<std::uint32_t>());
  case '.':
    pickle_.root = pop();
    isDone_ = true;
    return true;
  default:
    return false;
  }
}

std::uint64_t Machine::slotIn(std::string_view line) {
  const auto slot = integerInPickle(line);
  if (!slot || *slot < 0)
    fail(espalier::Shown::tr("opcode %1 has %2, expected the number of a memo"), {inQuotes(line)});
  return static_cast<std::uint64_t>(*slot);
}

bool Machine::get(std::uint64_t slot) {
  const auto found = memo_.find(slot);
  if (found == memo_.end())
    fail(
        espalier::Shown::tr("opcode %1 asks for memo %2, which was never set: the file is damaged"),
        {std::to_string(slot)});
  stack_.push_back(found->second);
  return true;
}

bool Machine::runObject() {
  switch (opcode_) {
  case 'c': {
    const std::string_view module = in_.takeUntil('\n');
    return pushName(module, in_.takeUntil('\n'));
  }
  case 0x93: {
    const PickleId name = pop();
    const PickleId module = pop();
    return pushName(
        valueOf<std::string>(
            module, espalier::Shown::tr(
                        "opcode %1 does not find the text of a module: the file is damaged")),
        valueOf<std::string>(
            name, espalier::Shown::tr(
                      "opcode %1 does not find the text of a name: the file is damaged")));
  }
  case 'R':
  case 0x81:
    return make();
  case 'b':
    return build();
  default:
    return false;
  }
}

bool Machine::pushName(std::string_view module, std::string_view name) {
  for (std::size_t i = 0; i < allowed_.size(); ++i)
    if (allowed_[i].module == module && allowed_[i].name == name) return push(PickleName{i});
  fail(espalier::Shown::tr("opcode %1 asks for %2 of %3, which a plant does not need, and this "
                           "file may be meant to do harm: it is not read. If you trust it, save it "
                           "as .mtg with the program that wrote it"),
       {inQuotes(name), inQuotes(module)});
}

bool Machine::make() {
  const PickleId arguments = pop();
  const std::size_t global =
      valueOf<PickleName>(
          pop(), espalier::Shown::tr("opcode %1 does not find a class: the file is damaged"))
          .global;
  constexpr auto ifNoTuple =
      espalier::Shown::tr("opcode %1 does not find a tuple: the file is damaged");
  if (valueOf<PickleSequence>(arguments, ifNoTuple).kind != Kind::tuple) fail(ifNoTuple);
  return push(PickleObject{global, arguments, std::nullopt});
}

bool Machine::build() {
  const PickleId state = pop();
  auto& object = valueOf<PickleObject>(
      top(), espalier::Shown::tr("opcode %1 does not find an object: the file is damaged"));
  if (object.state)
    fail(espalier::Shown::tr("opcode %1 sets the state of an object twice: the file is damaged"));
  object.state = state;
  return true;
}

} // namespace

Pickle readPickle(std::string_view bytes, std::span<const PickleGlobal> allowed,
                  const std::string& file) {
  return Machine(bytes, allowed, file).run();
}

} // namespace espalier
