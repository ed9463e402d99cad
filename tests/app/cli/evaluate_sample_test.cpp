#include "tests/app/cli/subcommands.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <gmock/gmock.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::Outcome;
using test::runProgram;
using test::Subcommands;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(Subcommands, EvaluateMeasuresAgainstTheTruth) {
  run({"reconstruct", scan_, "-o", file("a.mtg")});
  EXPECT_THAT(run({"evaluate", file("a.mtg"), truth_, "--json", file("a.json")}),
              HasSubstr("geometric index"));
  const json numbers = test::jsonIn(file("a.json"));
  for (const char* key : {"segments", "matched", "mapping", "geometric", "structural"})
    EXPECT_TRUE(numbers["authors"].contains(key)) << key;
  for (const char* key : {"distance", "precision", "recall", "f"})
    EXPECT_TRUE(numbers["tolerance"][0].contains(key)) << key;
  for (const char* key : {"shift", "traits", "result", "reference"})
    EXPECT_TRUE(numbers.contains(key)) << key;
  EXPECT_GT(numbers["authors"]["geometric"], 0.8);
  EXPECT_TRUE(numbers["registration"].is_object());
}

TEST_F(Subcommands, EvaluateCountsEditsAsAsked) {
  const std::string printed = run({"evaluate", truth_, truth_, "--edit-unit", "axis", "--edit-cost",
                                   "shape", "--merge-paths", "--json", file("a.json")});
  EXPECT_THAT(printed, HasSubstr("\nedit distance 0, similarity 1.000: 0 removed, 0 inserted\n"));
  const json edit = test::jsonIn(file("a.json"))["edit_distance"];
  EXPECT_EQ(edit["unit"], "axis");
  EXPECT_EQ(edit["cost"], "shape");
  EXPECT_EQ(edit["merge_paths"], true);
  EXPECT_EQ(edit["distance"], 0);
  EXPECT_GT(edit["removing_all"], 0);
  run({"evaluate", truth_, truth_, "--mapping", file("m.csv")});
  const std::string mapping = test::bytesOf(file("m.csv"));
  EXPECT_EQ(mapping.substr(0, 14), "edit,result,re");
  EXPECT_THAT(mapping, HasSubstr("\nmatched,"));
  EXPECT_THAT(mapping, Not(HasSubstr("\nremoved,")));
  const Outcome wrong = runProgram({"evaluate", truth_, truth_, "--edit-cost", "shap"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("choose one of topology, attributes, length, place, shape"));
}

TEST_F(Subcommands, EvaluateReportsWhereTheTwoAgree) {
  const std::string printed =
      run({"evaluate", truth_, truth_, "--where", "--json", file("a.json")});
  EXPECT_THAT(printed, HasSubstr("             order  precision     recall"));
  EXPECT_THAT(printed, HasSubstr("            height  precision     recall"));
  EXPECT_THAT(printed, HasSubstr("              more          0.0          0.0          0.0\n"));
  const json numbers = test::jsonIn(file("a.json"));
  EXPECT_EQ(numbers["by_place"]["by_height"].size(), 10U);
  EXPECT_EQ(numbers["by_place"]["by_order"][0]["recall"], 1);
  EXPECT_EQ(numbers["wood"]["result"], numbers["wood"]["reference"]);
  EXPECT_GT(numbers["wood"]["result"]["whole"]["volume"], 0);
}

TEST_F(Subcommands, EvaluateFindsAStructureEqualToItself) {
  run({"evaluate", truth_, truth_, "--no-register", "--json", file("a.json")});
  const json numbers = test::jsonIn(file("a.json"));
  EXPECT_EQ(numbers["authors"]["geometric"], 1);
  EXPECT_EQ(numbers["authors"]["structural"], 1);
  EXPECT_EQ(numbers["tolerance"][0]["f"], 1);
  EXPECT_TRUE(numbers["registration"].is_null());
  EXPECT_EQ(numbers["shift"], json({0, 0, 0}));
}

TEST_F(Subcommands, EvaluateReportsAShiftOnceAndNamesTheUnit) {
  std::string moved;
  for (int i = 0; i < 11; ++i) // a stick of 10 m, and the same 0.5 m beside it
    moved += std::to_string(i + 1) + '\t' + (i == 0 ? "" : std::to_string(i)) + "\t<\tAT\t0\t" +
             std::to_string(i) + "\t0.1\n";
  const auto stickAt = [&](const std::string& x) {
    std::string rows = moved;
    for (std::size_t at = rows.find("AT"); at != std::string::npos; at = rows.find("AT"))
      rows.replace(at, 2, x);
    return "# vid\tparentid\tedgetype\tXX\tYY\tZZ\tRadius\n11\n" + rows;
  };
  test::writeBytes(file("a.txt"), stickAt("0.5"));
  test::writeBytes(file("b.txt"), stickAt("0"));
  const Outcome named = runProgram({"evaluate", file("a.txt"), file("b.txt"), "--unit", "m"});
  EXPECT_EQ(named.status, 0);
  EXPECT_THAT(named.err, IsEmpty());
  EXPECT_THAT(named.out, HasSubstr(" m, 0.5 m in all, to lie on the reference\n"));
  EXPECT_THAT(named.out, HasSubstr("distance/m"));
  const Outcome plain = runProgram({"evaluate", file("a.txt"), file("b.txt")});
  EXPECT_THAT(plain.err, IsEmpty());
  EXPECT_THAT(plain.out, HasSubstr(" (in the unit of the structures), 0.5 in all"));
}

} // namespace
} // namespace espalier
