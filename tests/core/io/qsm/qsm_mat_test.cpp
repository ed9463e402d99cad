#include "core/base/shown_message.h"
#include "core/io/formats.h"
#include "core/io/qsm/qsm_mat.h"
#include "core/io/qsm/qsm_table.h"
#include "tests/core/io/qsm/mat_writer.h"
#include "tests/core/io/qsm/qsm_samples.h"
#include "tests/core/io/samples.h"
#include "tests/support/canonical.h"
#include "tests/support/shared_data.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using test::elementsOf;
using test::matElement;
using test::matFile;
using test::MatNumbers;
using test::matStruct;
using test::MatType;
using test::qsmFields;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Imported<Skeleton> importQsmMat(const std::string& bytes) {
  std::istringstream in(bytes);
  return readQsmMat(in, "oak.mat");
}

std::string refusalOfQsmMat(const std::string& bytes) {
  return test::errorOf([&] { return importQsmMat(bytes); });
}

/// The same tree as a table.
Skeleton treeOfTable() {
  std::istringstream in(test::treeQsmTable());
  return readQsmTable(in, "oak.csv").value;
}

std::string cylinderWith(const std::string& name, const MatNumbers& numbers) {
  auto fields = qsmFields();
  for (auto& [field, old] : fields)
    if (field == name) old = numbers;
  return matStruct("", elementsOf(fields));
}

std::string fileWith(const std::string& name, const MatNumbers& numbers) {
  return matFile({matStruct("QSM", {{"cylinder", cylinderWith(name, numbers)}})}, false);
}

TEST(ReadQsmMat, FindsTheModelPlainAndCompressed) {
  const std::string model = matStruct("QSM", {{"cylinder", cylinderWith("", {})}});
  for (const bool isCompressed : {false, true}) {
    const Imported<Skeleton> tree = importQsmMat(matFile({model}, isCompressed));
    EXPECT_EQ(test::canonical(tree.value), test::canonical(treeOfTable()));
    EXPECT_THAT(tree.notes, IsEmpty());
  }
}

// Of the corpus of the fuzz target: packed by zlib itself, where the other tests store.
TEST(ReadQsmMat, UnpacksWhatZlibPacked) {
  for (const char* name : {"plain.mat", "compressed.mat"})
    EXPECT_EQ(
        test::canonical(readStructure(test::sourceFolder() / "tests/fuzz/corpus/qsm_mat" / name)
                            .value.skeleton),
        test::canonical(treeOfTable()))
        << name;
}

TEST(ReadQsmMat, FindsItBehindOtherVariablesAndFields) {
  const std::string numbers = matElement({2, 2, {1, 2, 3, 4}, MatType::real}, "P");
  const std::string other =
      matStruct("inputs", {{"PatchDiam", matElement({1, 1, {0.1}, MatType::real})}});
  const std::string model =
      matStruct("OptQSM", {{"rundata", matStruct("", {{"a", matElement({1, 1, {1}})}})},
                           {"cylinder", cylinderWith("", {})}});
  EXPECT_EQ(test::canonical(importQsmMat(matFile({numbers, other, model}, true)).value),
            test::canonical(treeOfTable()));
}

TEST(ReadQsmMat, TakesTheCylindersAlone) {
  EXPECT_EQ(test::canonical(importQsmMat(matFile({cylinderWith("", {})}, false)).value),
            test::canonical(treeOfTable()));
}

TEST(ReadQsmMat, TakesTheFirstOfSeveralModelsAndSaysSo) {
  const std::string models = matStruct("QSM", {{"cylinder", cylinderWith("", {})}}, 3);
  const Imported<Skeleton> tree = importQsmMat(matFile({models}, true));
  EXPECT_EQ(test::canonical(tree.value), test::canonical(treeOfTable()));
  EXPECT_THAT(eachInEnglish(tree.notes),
              ElementsAre("oak.mat: holds 3 models, of which the first is read"));
}

TEST(ReadQsmMat, DoesWithoutTheFieldsThatAreNotNeeded) {
  auto fields = qsmFields();
  std::erase_if(fields, [](const auto& field) {
    return field.first == "extension" || field.first == "BranchOrder" || field.first == "added";
  });
  const std::string file =
      matFile({matStruct("QSM", {{"cylinder", matStruct("", elementsOf(fields))}})}, false);
  EXPECT_EQ(test::canonical(importQsmMat(file).value), test::canonical(treeOfTable()));
}

TEST(ReadQsmMat, RefusesFilesWithoutAModel) {
  EXPECT_THAT(refusalOfQsmMat(std::string(200, ' ')), HasSubstr("is no MAT file"));
  EXPECT_THAT(refusalOfQsmMat("MATLAB 5.0 MAT-file"), HasSubstr("cut short"));
  std::string newer = matFile({}, false);
  newer.replace(7, 3, "7.3");
  EXPECT_THAT(refusalOfQsmMat(newer), HasSubstr("save(name, '-v7', ...)"));
  EXPECT_THAT(refusalOfQsmMat(matFile({}, false)), HasSubstr("holds no model of TreeQSM"));
  EXPECT_THAT(refusalOfQsmMat(matFile({matElement({1, 1, {1}})}, true)),
              HasSubstr("holds no model"));
  EXPECT_THAT(
      refusalOfQsmMat(matFile({matStruct("QSM", {{"branch", matElement({1, 1, {1}})}})}, false)),
      HasSubstr("holds no model"));
  EXPECT_THAT(
      refusalOfQsmMat(matFile({matStruct("QSM", {{"cylinder", matElement({1, 1, {1}})}})}, false)),
      HasSubstr("holds no model"));
  EXPECT_THAT(refusalOfQsmMat(matFile({matStruct("QSM", {}, 0)}, false)),
              HasSubstr("holds no model"));
}

TEST(ReadQsmMat, RefusesFieldsThatDoNotFit) {
  auto fields = qsmFields();
  std::erase_if(fields, [](const auto& field) { return field.first == "axis"; });
  EXPECT_THAT(refusalOfQsmMat(matFile({matStruct("", elementsOf(fields))}, false)),
              HasSubstr("field 'axis' of its cylinders is missing"));
  EXPECT_THAT(refusalOfQsmMat(fileWith("length", {3, 1, {1, 2, 3}})),
              HasSubstr("field 'length' of its cylinders has 3 x 1 values, expected 4 x 1"));
  EXPECT_THAT(refusalOfQsmMat(fileWith("radius", {4, 2, {1, 2, 3, 4, 5, 6, 7, 8}})),
              HasSubstr("has 4 x 2 values, expected N x 1"));
  EXPECT_THAT(refusalOfQsmMat(fileWith("radius", {1, 4, {1, 2, 3, 4}})),
              HasSubstr("has 1 x 4 values, expected N x 1"));
  EXPECT_THAT(refusalOfQsmMat(fileWith("parent", {4, 1, {0, 1, 9, 3}})),
              HasSubstr("cylinder 3 is attached to cylinder 9, and there are 4"));
  EXPECT_THAT(refusalOfQsmMat(fileWith("parent", {4, 1, {0, 1, 0.5, 3}})),
              HasSubstr("cylinder 3 has no whole number as parent"));
  EXPECT_THAT(refusalOfQsmMat(fileWith("parent", {4, 1, {2, 1, 1, 3}})),
              HasSubstr("is among its own ancestors"));
  EXPECT_THAT(refusalOfQsmMat(fileWith("length", {4, 1, {1, -2, 3, 4}})),
              HasSubstr("negative length"));
  EXPECT_THAT(refusalOfQsmMat(fileWith("axis", {4, 3, {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 9, 0}})),
              HasSubstr("cylinder 3 has an axis that is not of length 1"));
  EXPECT_THAT(refusalOfQsmMat(fileWith("radius", {0, 1, {}})), HasSubstr("expected 0 x 1"));
}

TEST(ReadQsmMat, DoesNotTrustItsSizes) {
  EXPECT_THAT(refusalOfQsmMat(fileWith("radius", {0x7fffffff, 1, {1}})),
              HasSubstr("has 1 number, expected 2147483647 x 1"));
  auto fields = qsmFields(); // more rows than values
  for (auto& [name, numbers] : fields)
    numbers.rows = 100;
  EXPECT_THAT(refusalOfQsmMat(matFile({matStruct("", elementsOf(fields))}, false)),
              HasSubstr("has 4 numbers, expected 100 x 1"));
}

TEST(ReadQsmMat, RefusesAFileCutShort) {
  const std::string bytes = test::qsmMatFile();
  for (std::size_t size = 0; size < bytes.size(); size += 7)
    EXPECT_NE(refusalOfQsmMat(bytes.substr(0, size)), "") << size;
}

TEST(ReadQsmMat, RefusesAStreamThatWasChanged) {
  std::string bytes = test::qsmMatFile();
  bytes[bytes.size() / 2] ^= 1;
  EXPECT_THAT(refusalOfQsmMat(bytes), HasSubstr("cannot be unpacked"));
}

// A stream of a few kilobytes stands for gigabytes of zeros.
TEST(ReadQsmMat, DoesNotUnpackWhatNoModelFills) {
  const auto zeros = [](std::uint32_t rows) {
    return matElement({rows, 1, std::vector<double>(rows), MatType::int8}, "z");
  };
  EXPECT_THAT(refusalOfQsmMat(matFile({zeros(140'000'000)}, true)),
              HasSubstr("unpacks to over 128 MiB, as of no model"));
  EXPECT_THAT(refusalOfQsmMat(matFile({zeros(120'000'000)}, true)),
              HasSubstr("has 120000000 numbers in one array"));
  EXPECT_THAT(refusalOfQsmMat(fileWith(
                  "radius", {5'000'000, 1, std::vector<double>(5'000'000), MatType::int8})),
              HasSubstr("has 5000000 numbers in one array"));
}

} // namespace
} // namespace espalier
