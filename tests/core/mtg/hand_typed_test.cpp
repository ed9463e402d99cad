#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/formats.h"
#include "core/mtg/mtg_lines.h"
#include "core/mtg/mtg_parser.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_text_edit.h"
#include "core/mtg/mtg_values.h"
#include "core/mtg/mtg_writer.h"
#include "tests/core/mtg/hand_typed.h"
#include "tests/core/mtg/mtg_text.h"
#include "tests/support/shared_data.h"

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <set>
#include <sstream>

namespace espalier {
namespace {

Imported<Mtg> imported(const std::string& text) {
  std::istringstream in(text);
  return readMtg(in, "plant.mtg");
}

Mtg read(const std::string& text) {
  return imported(text).value;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    lines.back() += c;
    const bool isMac = text.find('\n') == std::string::npos;
    if (c == (isMac ? '\r' : '\n')) lines.emplace_back();
  }
  return lines;
}

/// How many lines of one text are not in the other, in their order, at most.
struct Difference {
  std::size_t gone = 0;
  std::size_t added = 0;

  Difference(const std::string& before, const std::string& after) {
    const std::vector<std::string> a = linesOf(before);
    const std::vector<std::string> b = linesOf(after);
    std::size_t start = 0;
    while (start < std::min(a.size(), b.size()) && a[start] == b[start])
      ++start;
    std::size_t same = 0;
    while (same < std::min(a.size(), b.size()) - start &&
           a[a.size() - 1 - same] == b[b.size() - 1 - same])
      ++same;
    gone = a.size() - start - same;
    added = b.size() - start - same;
  }
};

class HandTypedMtg : public testing::TestWithParam<test::HandTyped> {
protected:
  [[nodiscard]] static const std::string& text() { return GetParam().text; }

  /// The last vertex that is attached to another, carries none and has a line for itself.
  [[nodiscard]] static std::optional<std::size_t> apexOf(const Mtg& mtg) {
    std::set<std::size_t> alone;
    std::size_t made = 0; // vertices of the lines before
    for (const MtgLine& line : parseMtg(text(), "plant.mtg").lines) {
      if (indexOf(line.last) == made) alone.insert(made);
      made = std::max(made, indexOf(line.last) + 1);
    }
    std::set<std::size_t> carriers;
    for (const MtgVertex& vertex : mtg.vertices)
      for (const auto& link : {vertex.parent, vertex.complex})
        if (link) carriers.insert(indexOf(*link));
    for (std::size_t i = mtg.vertices.size(); i-- > 1;)
      if (!carriers.contains(i) && alone.contains(i) && mtg.vertices[i].parent) return i;
    return std::nullopt;
  }
};

TEST(HandTypedTexts, AreOf45KindsAndMore) {
  std::set<std::string> texts;
  for (const test::HandTyped& each : test::handTypedTexts())
    texts.insert(each.text);
  EXPECT_GE(texts.size(), 45U);
  EXPECT_EQ(texts.size(), test::handTypedTexts().size()) << "each is another one";
}

TEST_P(HandTypedMtg, IsReadAsItSays) {
  const Imported<Mtg> mtg = imported(text());
  std::vector<std::size_t> scales = {1};
  std::size_t successors = 0;
  std::size_t branchings = 0;
  for (const MtgVertex& each : mtg.value.vertices) {
    const auto scale = static_cast<std::size_t>(each.scale);
    scales.resize(std::max(scales.size(), scale + 1));
    ++scales[scale];
    if (each.parent) ++(each.edge == EdgeType::successor ? successors : branchings);
  }
  std::string counts;
  for (const std::size_t count : scales)
    counts += (counts.empty() ? "" : ",") + std::to_string(count);
  EXPECT_EQ(counts + '\t' + std::to_string(successors) + '\t' + std::to_string(branchings),
            GetParam().counts);
  EXPECT_EQ(mtg.notes.size(), GetParam().notes) << testing::PrintToString(eachInEnglish(mtg.notes));
}

TEST_P(HandTypedMtg, IsSavedUnchangedIfNothingWasEdited) {
  const auto folder = test::freshFolder();
  writeAtomically(folder / "typed.mtg", [](std::ostream& out) { out << text(); });
  const Structure structure = readAnyStructure(folder / "typed.mtg").value;
  writeStructure(folder / "saved.mtg", structure);
  std::ifstream in(folder / "saved.mtg", std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), text());
}

TEST_P(HandTypedMtg, WrittenAnewIsReadAsTheSamePlant) {
  const Mtg mtg = read(text());
  const Mtg back = read(test::written(mtg));
  EXPECT_EQ(back, mtgAsWritten(mtg)) << test::written(mtg);
  std::multiset<std::string> labels;
  std::multiset<std::string> labelsBack;
  for (const MtgVertex& each : mtg.vertices)
    labels.insert(mtgLabel(each));
  for (const MtgVertex& each : back.vertices)
    labelsBack.insert(mtgLabel(each));
  EXPECT_EQ(labelsBack, labels) << "with dots and zeros as typed";
}

TEST_P(HandTypedMtg, OneValueThatIsEditedChangesItsLineAlone) {
  Mtg mtg = read(text());
  std::size_t edited = 0;
  for (std::size_t i = 0; i < mtg.vertices.size(); ++i)
    for (std::size_t feature = 0; feature < mtg.vertices[i].values.size(); ++feature) {
      if (mtg.vertices[i].values[feature].empty() || mtg.features[feature].type == "DD/MM/YYYY")
        continue;
      const bool isShared =
          i + 1 < mtg.vertices.size() && mtg.vertices[i].values == mtg.vertices[i + 1].values;
      if (isShared || (i > 0 && mtg.vertices[i].values == mtg.vertices[i - 1].values)) continue;
      Mtg other = mtg;
      other.vertices[i].values[feature] = isNumberFeature(mtg.features[feature]) ? "77" : "burnt";
      const std::string after = mtgTextWith(text(), other);
      const Difference difference(text(), after);
      EXPECT_EQ(difference.gone, 1U) << after;
      EXPECT_EQ(difference.added, 1U) << after;
      EXPECT_EQ(read(after), other);
      ++edited;
    }
  EXPECT_TRUE(edited > 0 || std::string(GetParam().kind) == "NoFeatures");
}

TEST_P(HandTypedMtg, OneLabelThatIsEditedChangesItsLineAlone) {
  Mtg mtg = read(text());
  const auto apex = apexOf(mtg);
  if (!apex) return;
  mtg.vertices[*apex].index = 99;
  const std::string after = mtgTextWith(text(), mtg);
  const Difference difference(text(), after);
  EXPECT_EQ(difference.gone, 1U) << after;
  EXPECT_EQ(difference.added, 1U) << after;
  EXPECT_EQ(read(after), mtg);
}

TEST_P(HandTypedMtg, OneVertexThatIsAddedIsOneLineMore) {
  Mtg mtg = read(text());
  const auto apex = apexOf(mtg);
  if (!apex) return;
  MtgVertex shoot = mtg.vertices[*apex];
  shoot.index = 98;
  shoot.parent = VertexId{static_cast<std::uint32_t>(*apex)};
  shoot.edge = EdgeType::branching;
  shoot.values = {};
  shoot.later = {};
  mtg.vertices.push_back(shoot);
  const std::string after = mtgTextWith(text(), mtg);
  const Difference difference(text(), after);
  EXPECT_EQ(difference.added, difference.gone + 1) << after;
  EXPECT_LE(difference.gone, 1U) << "a last line may get an end" << after;
  EXPECT_EQ(mtgAsWritten(read(after)).vertices, mtgAsWritten(mtg).vertices) << after;
}

TEST_P(HandTypedMtg, OneVertexThatGoesTakesItsLineAlone) {
  Mtg mtg = read(text());
  const auto apex = apexOf(mtg);
  if (!apex) return;
  mtg.vertices.erase(mtg.vertices.begin() + static_cast<std::ptrdiff_t>(*apex));
  for (MtgVertex& each : mtg.vertices)
    for (auto* link : {&each.parent, &each.complex})
      if (*link && indexOf(**link) > *apex)
        *link = VertexId{static_cast<std::uint32_t>(indexOf(**link) - 1)};
  const std::string after = mtgTextWith(text(), mtg);
  const Difference difference(text(), after);
  EXPECT_LE(difference.gone, 3U) << "with its dates" << after;
  EXPECT_LE(difference.added, 1U) << "a comment that stood there" << after;
  EXPECT_EQ(mtgAsWritten(read(after)).vertices, mtgAsWritten(mtg).vertices) << after;
}

INSTANTIATE_TEST_SUITE_P(All, HandTypedMtg, testing::ValuesIn(test::handTypedTexts()),
                         [](const auto& tested) { return std::string(tested.param.kind); });

class DoubtfulMtg : public testing::TestWithParam<test::Doubtful> {};

TEST_P(DoubtfulMtg, IsRefusedWithTheCellAndWhatToTry) {
  try {
    (void)read(GetParam().text);
    ADD_FAILURE() << "read";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(All, DoubtfulMtg, testing::ValuesIn(test::doubtfulTexts()),
                         [](const auto& tested) { return std::string(tested.param.kind); });

} // namespace
} // namespace espalier
