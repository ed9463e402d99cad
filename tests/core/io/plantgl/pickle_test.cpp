#include "core/io/plantgl/pickle.h"
#include "tests/core/io/samples.h"

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr auto allowed = std::to_array<PickleGlobal>({{"plant", "Tree"}, {"plant.math", "Point"}});

std::string operator""_b(const char* bytes, std::size_t size) {
  return {bytes, size}; // with the zeros in it
}

Pickle importPickle(const std::string& bytes) {
  return readPickle(bytes, allowed, "oak.bmtg");
}

std::string refusalOfPickle(const std::string& bytes) {
  return test::errorOf([&] { return importPickle(bytes); });
}

/// The root as text: 1, 2.5, 'a', [1], (1, 2), {1}, {1: 2}, <0> for a name, <0>(args)|state.
std::string written(const Pickle& pickle, PickleId id) {
  const auto list = [&](const std::vector<PickleId>& items) {
    std::string text;
    for (const PickleId item : items)
      text += (text.empty() ? "" : ", ") + written(pickle, item);
    return text;
  };
  const PickleValue& value = pickle[id];
  if (std::holds_alternative<PickleNone>(value)) return "None";
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "True" : "False";
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  if (const auto* real = std::get_if<double>(&value)) return std::to_string(*real);
  if (const auto* text = std::get_if<std::string>(&value)) return "'" + *text + "'";
  if (const auto* name = std::get_if<PickleName>(&value))
    return "<" + std::to_string(name->global) + ">";
  if (const auto* sequence = std::get_if<PickleSequence>(&value)) {
    const std::string items = list(sequence->items);
    if (sequence->kind == PickleSequence::Kind::list) return "[" + items + "]";
    return sequence->kind == PickleSequence::Kind::tuple ? "(" + items + ")" : "{" + items + "}";
  }
  if (const auto* dict = std::get_if<PickleDict>(&value)) {
    std::string text;
    for (const auto& [key, entry] : dict->items)
      text += (text.empty() ? "" : ", ") + written(pickle, key) + ": " + written(pickle, entry);
    return "{" + text + "}";
  }
  const auto& object = std::get<PickleObject>(value);
  return "<" + std::to_string(object.global) + ">" + written(pickle, object.arguments) +
         (object.state ? "|" + written(pickle, *object.state) : "");
}

std::string rootOf(const std::string& bytes) {
  const Pickle pickle = importPickle(bytes);
  return written(pickle, pickle.root);
}

struct Sample {
  std::string bytes;
  std::string expected;
};

class ReadPickleOfPlainData : public testing::TestWithParam<Sample> {};

TEST_P(ReadPickleOfPlainData, FindsItsValue) {
  EXPECT_EQ(rootOf(GetParam().bytes), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Numbers, ReadPickleOfPlainData,
    testing::Values(Sample{"N.", "None"}, Sample{"\x88.", "True"}, Sample{"\x89.", "False"},
                    Sample{"I01\n.", "True"}, Sample{"I00\n.", "False"}, Sample{"I-7\n.", "-7"},
                    Sample{"L12L\n.", "12"}, Sample{"J\xfe\xff\xff\xff.", "-2"},
                    Sample{"K\xff.", "255"}, Sample{"M\x01\x02.", "513"},
                    Sample{"\x8a\x00."_b, "0"}, Sample{"\x8a\x01\xff.", "-1"},
                    Sample{"\x8a\x02\xff\x00."_b, "255"},
                    Sample{"\x8a\x08\xff\xff\xff\xff\xff\xff\xff\x7f.", "9223372036854775807"},
                    Sample{"\x8b\x02\x00\x00\x00\x00\x80."_b, "-32768"},
                    Sample{"G\x3f\xf8\x00\x00\x00\x00\x00\x00."_b, "1.500000"},
                    Sample{"F-2.5\n.", "-2.500000"}));

INSTANTIATE_TEST_SUITE_P(
    Texts, ReadPickleOfPlainData,
    testing::Values(Sample{"S'a\\x41\\n\\\\\\''\n.", "'aA\n\\''"}, Sample{"S\"b\"\n.", "'b'"},
                    Sample{"Vq\\u00e9\xe9\\U0001F333\n.", "'q\xc3\xa9\xc3\xa9\xf0\x9f\x8c\xb3'"},
                    Sample{"T\x02\x00\x00\x00hi."_b, "'hi'"}, Sample{"U\x02hi.", "'hi'"},
                    Sample{"X\x02\x00\x00\x00hi."_b, "'hi'"}, Sample{"\x8c\x02hi.", "'hi'"},
                    Sample{"\x8d\x02\x00\x00\x00\x00\x00\x00\x00hi."_b, "'hi'"},
                    Sample{"B\x02\x00\x00\x00hi."_b, "'hi'"}, Sample{"C\x02hi.", "'hi'"},
                    Sample{"\x8e\x02\x00\x00\x00\x00\x00\x00\x00hi."_b, "'hi'"},
                    Sample{"\x96\x02\x00\x00\x00\x00\x00\x00\x00hi."_b, "'hi'"}));

INSTANTIATE_TEST_SUITE_P(
    Containers, ReadPickleOfPlainData,
    testing::Values(Sample{"].", "[]"}, Sample{").", "()"}, Sample{"}.", "{}"},
                    Sample{"\x8f.", "{}"}, Sample{"(K\x01K\x02l.", "[1, 2]"},
                    Sample{"(K\x01K\x02t.", "(1, 2)"}, Sample{"(K\x01K\x02\x64.", "{1: 2}"},
                    Sample{"(K\x01\x91.", "{1}"}, Sample{"K\x01\x85.", "(1)"},
                    Sample{"K\x01K\x02\x86.", "(1, 2)"},
                    Sample{"K\x01K\x02K\x03\x87.", "(1, 2, 3)"}, Sample{"]K\x01\x61.", "[1]"},
                    Sample{"](K\x01K\x02\x65.", "[1, 2]"}, Sample{"\x8f(K\x01\x90.", "{1}"},
                    Sample{"}K\x01K\x02s.", "{1: 2}"},
                    Sample{"}(K\x01K\x02K\x03K\x04u.", "{1: 2, 3: 4}"}));

INSTANTIATE_TEST_SUITE_P(
    Stack, ReadPickleOfPlainData,
    testing::Values(Sample{"\x80\x02K\x01.", "1"},
                    Sample{"\x80\x05\x95\x03\x00\x00\x00\x00\x00\x00\x00K\x01."_b, "1"},
                    Sample{"K\x01K\x02\x30.", "1"}, Sample{"K\x01(0.", "1"},
                    Sample{"K\x01(K\x02K\x03\x31.", "1"}, Sample{"K\x01\x32\x86.", "(1, 1)"},
                    Sample{"K\x05p3\n0g3\n.", "5"}, Sample{"K\x05q\x03\x30h\x03.", "5"},
                    Sample{"K\x05r\x00\x01\x00\x00\x30j\x00\x01\x00\x00."_b, "5"},
                    Sample{"K\x05\x94K\x06\x94\x30\x30h\x01."_b, "6"}));

INSTANTIATE_TEST_SUITE_P(Objects, ReadPickleOfPlainData,
                         testing::Values(Sample{"cplant\nTree\n.", "<0>"},
                                         Sample{"\x8c\x0aplant.math\x8c\x05Point\x93.", "<1>"},
                                         Sample{"cplant\nTree\n)\x81.", "<0>()"},
                                         Sample{"cplant.math\nPoint\n(K\x01K\x02tR.", "<1>(1, 2)"},
                                         Sample{"cplant\nTree\n)\x81}K\x01K\x02sb.",
                                                "<0>()|{1: 2}"}));

TEST(ReadPickle, SharesWhatThePickleShares) {
  const Pickle pickle =
      importPickle("]q\x01h\x01K\x07\x61\x86."); // one list twice; the 7 goes into both
  EXPECT_THAT(refusalOfPickle("]q\x01h\x01K\x07\x61\x86."), "");
  EXPECT_EQ(written(pickle, pickle.root), "([7], [7])");
}

TEST(ReadPickle, TakesAListThatHoldsItself) {
  const Pickle pickle = importPickle("]q\x01h\x01\x61.");
  const auto& list = std::get<PickleSequence>(pickle[pickle.root]);
  EXPECT_THAT(list.items, ElementsAre(pickle.root));
}

TEST(ReadPickle, TakesDepthWithoutRecursion) {
  const std::size_t depth = 1'000'000;
  std::string bytes(depth, ']');
  bytes.append(depth - 1, 'a').append(1, '.');
  EXPECT_EQ(importPickle(bytes).values.size(), depth);
  EXPECT_THAT(refusalOfPickle(std::string(depth, '(')), HasSubstr("cut short"));
}

TEST(ReadPickle, PassesOverWhatFollowsItsEnd) {
  EXPECT_EQ(rootOf("K\x01.cos\nsystem\n"), "1");
}

TEST(ReadPickle, RefusesEveryOtherName) {
  EXPECT_EQ(
      refusalOfPickle("cos\nsystem\n(S'ls'\ntR."),
      "oak.bmtg, byte 0: opcode 0x63 GLOBAL asks for 'system' of 'os', which a plant does not "
      "need, and this file may be meant to do harm: it is not read. If you trust it, save it "
      "as .mtg with the program that wrote it");
  EXPECT_THAT(
      refusalOfPickle("K\x01\x8c\x08"
                      "builtins\x8c\x04"
                      "eval\x93."),
      AllOf(HasSubstr("byte 18: opcode 0x93 STACK_GLOBAL"), HasSubstr("'eval' of 'builtins'")));
  for (const char* name : {"plant\nPoint", "plant.math\nTree", "plant\nTree.x", "plant \nTree",
                           "copy_reg\n_reconstructor", "\n", "posix\nsystem"})
    EXPECT_THAT(refusalOfPickle("c" + std::string(name) + "\n."), HasSubstr("meant to do harm"))
        << name;
}

TEST(ReadPickle, RefusesOpcodesThatAreNotPlainData) {
  const std::vector<std::pair<std::string, std::string>> opcodes = {
      {"P1\n.", "0x50 PERSID"},
      {"K\x01Q.", "0x51 BINPERSID"},
      {"(iplant\nTree\n.", "0x69 INST"},
      {"(cplant\nTree\no.", "0x6f OBJ"},
      {"\x82\x01.", "0x82 EXT1"},
      {"\x83\x01\x01.", "0x83 EXT2"},
      {"\x84\x01\x01\x01\x01.", "0x84 EXT4"},
      {"cplant\nTree\n)}\x92.", "0x92 NEWOBJ_EX"},
      {"\x97.", "0x97 NEXT_BUFFER"},
      {"K\x01\x98.", "0x98 READONLY_BUFFER"},
      {"\xff.", "0xff"},
      {"?.", "0x3f"}};
  for (const auto& [bytes, name] : opcodes)
    EXPECT_THAT(refusalOfPickle(bytes),
                AllOf(HasSubstr("opcode " + name), HasSubstr("meant to do harm")));
}

TEST(ReadPickle, CallsNothingThatIsNoNameAllowed) {
  EXPECT_THAT(refusalOfPickle("K\x01)R."), HasSubstr("does not find a class"));
  EXPECT_THAT(refusalOfPickle("cplant\nTree\n)\x81)R."), HasSubstr("does not find a class"));
  EXPECT_THAT(refusalOfPickle("S'os.system'\n)\x81."), HasSubstr("does not find a class"));
  EXPECT_THAT(refusalOfPickle("cplant\nTree\n]R."), HasSubstr("does not find a tuple"));
  EXPECT_THAT(refusalOfPickle("cplant\nTree\nK\x01R."), HasSubstr("does not find a tuple"));
  EXPECT_THAT(refusalOfPickle("]}b."), HasSubstr("does not find an object"));
  EXPECT_THAT(refusalOfPickle("cplant\nTree\n)\x81}b}b."), HasSubstr("twice"));
}

TEST(ReadPickle, RefusesWhatDoesNotFit) {
  const std::vector<std::pair<std::string, std::string>> broken = {
      {"", "byte 0: ends within"},
      {"K", "byte 1: ends within"},
      {"K\x01", "byte 2: ends within"},
      {"I1", "ends within a text"},
      {"T\xff\xff\xff\xff.", "negative length"},
      {"X\xff\xff\xff\xffhi.", "ends within a value of 4294967295 bytes"},
      {"\x8d\xff\xff\xff\xff\xff\xff\xff\xffhi.", "ends within a value of 18446744073709551615"},
      {"\x8b\xff\xff\xff\xff.", "negative length"},
      {"\x80\x06.", "asks for protocol 6"},
      {"Iabc\n.", "expected an integer"},
      {"I99999999999999999999\n.", "expected an integer"},
      {"\x8a\x09\x01\x01\x01\x01\x01\x01\x01\x01\x01.", "more than 64 bits"},
      {"F1,5\n.", "expected a number"},
      {"Sabc\n.", "expected a text in quotes"},
      {"S'a\\q'\n.", "expected a text in quotes"},
      {"S'\n.", "expected a text in quotes"},
      {"h\x01.", "asks for memo 1, which was never set"},
      {"g-1\n.", "expected the number of a memo"},
      {".", "opcode 0x2e STOP finds nothing"},
      {"0.", "finds nothing"},
      {"q\x01.", "finds nothing"},
      {"K\x01(\x85.", "finds nothing"}, // what lies below a mark is out of reach
      {"K\x01l.", "finds no mark"},
      {"K\x01t.", "finds no mark"},
      {"K\x01K\x02\x61.", "does not find a list"},
      {"}(K\x01\x65.", "does not find a list"},
      {")K\x01\x61.", "does not find a list"},
      {"](K\x01\x90.", "does not find a list or set"},
      {"]K\x01K\x02s.", "does not find a dict"},
      {"}(K\x01u.", "a key without a value"},
      {"(K\x01\x64.", "a key without a value"},
      {"K\x01K\x02\x93.", "does not find the text of a"}};
  for (const auto& [bytes, what] : broken)
    EXPECT_THAT(refusalOfPickle(bytes), HasSubstr(what)) << testing::PrintToString(bytes);
}

} // namespace
} // namespace espalier
