// A reference answers what the program asks.
#include "core/io/formats.h"
#include "core/skeleton/length_along.h"
#include "tests/app/cli/subcommands.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace espalier {
namespace {

using test::bytesOf;
using test::expectRefusal;
using test::runProgram;
using testing::HasSubstr;

struct Answer : test::Subcommands {};

TEST_F(Answer, PrintsScoresAndWritesThePlantAndTheNumbers) {
  const std::string printed =
      run({"answer", scan_, "--oracle", truth_, "--answers", "12", "--decide-rest", "-o",
           file("answered.mtg"), "--json", file("answers.json")});
  EXPECT_THAT(printed, HasSubstr(" answers  changes   doubts"));
  const auto json = nlohmann::json::parse(bytesOf(file("answers.json")));
  ASSERT_GE(json["rows"].size(), 4U);
  EXPECT_EQ(json["rows"].front()["answers"], 0);
  EXPECT_EQ(json["rows"].back()["answers"], 12);
  EXPECT_EQ(json["order"], "gain");
  EXPECT_GE(json["rows"].back()["right"], json["rows"].front()["right"]);
  EXPECT_GE(json["rest"]["changes"], json["rows"].back()["changes"]) << "those before count, too";
  EXPECT_THAT(bytesOf(file("answered.mtg")), HasSubstr("CODE"));
}

TEST_F(Answer, AsksAboutThePointsThatThePlantIsOf) {
  for (const test::Arguments& thin :
       {test::Arguments{}, {"--set", "thin.method=random", "--set", "thin.share=0.05"}}) {
    test::Arguments reconstruct = {"reconstruct", scan_,    "-o",
                                   file("a.mtg"), "--json", file("plant.json")};
    test::Arguments answer = {"answer",    scan_, "--oracle", truth_,
                              "--answers", "0",   "--json",   file("answers.json")};
    reconstruct.insert(reconstruct.end(), thin.begin(), thin.end());
    answer.insert(answer.end(), thin.begin(), thin.end());
    run(reconstruct);
    run(answer);
    const auto inDoubt = nlohmann::json::parse(bytesOf(file("plant.json")))["in_doubt"];
    const auto row = nlohmann::json::parse(bytesOf(file("answers.json")))["rows"].front();
    EXPECT_EQ(row["doubts_left"], inDoubt["count"]);
    EXPECT_EQ(row["expected_right"], inDoubt["expected_right"]);
  }
}

// Nodes are rows, as of the file that is written, and what has no node yet has its places.
TEST_F(Answer, NamesTheNodesOfTheWrittenFileInDoubts) {
  run({"reconstruct", scan_, "--set", "prune.length=25sp", "-o", file("tree.mtg"), "--json",
       file("tree.json")}); // so that branches are missing
  const auto inDoubt = nlohmann::json::parse(bytesOf(file("tree.json")))["in_doubt"];
  const Skeleton plant = readStructure(file("tree.mtg")).value.skeleton;
  const std::vector<NodeId> rows = plant.ids();
  const auto isAt = [&](const nlohmann::json& row, const nlohmann::json& place) {
    const Eigen::Vector3d& position = plant[rows.at(row.get<std::size_t>())].position;
    return position == Eigen::Vector3d(place.at(0), place.at(1), place.at(2));
  };
  std::size_t attached = 0;
  std::size_t added = 0;
  for (const auto& doubt : inDoubt["doubts"]) {
    EXPECT_TRUE(isAt(doubt["node"], doubt["place"]));
    if (doubt["kind"] != "missing") {
      EXPECT_EQ(doubt["nodes"].front(), doubt["node"]);
    }
    double length = 0;
    for (std::size_t i = 0; i < doubt["nodes"].size(); ++i) {
      const NodeId id = rows.at(doubt["nodes"][i].get<std::size_t>());
      if (i > 0) {
        EXPECT_EQ(plant[id].parent, rows.at(doubt["nodes"][i - 1].get<std::size_t>()));
      }
      length += edgeLength(plant, id);
    }
    if (doubt["kind"] != "missing") {
      EXPECT_NEAR(doubt["length"].get<double>(), length, 1e-6 * length);
    }
    for (const auto& one : doubt["alternatives"]) {
      EXPECT_EQ(one.contains("onto"), one["kind"] == "attach");
      EXPECT_EQ(one.contains("branch"), one["kind"] == "add");
      if (one["kind"] == "attach") {
        ++attached;
        EXPECT_TRUE(isAt(one["onto"], one["onto_place"]));
      }
      if (one["kind"] == "add") {
        ++added;
        EXPECT_GE(one["branch"].size(), 2U);
        EXPECT_EQ(one["branch"].back().size(), 3U);
      }
    }
  }
  EXPECT_GT(attached, 0U);
  EXPECT_GT(added, 0U);
}

TEST_F(Answer, NeverReplacesWhatItReads) {
  const std::string preset = file("preset.json");
  test::writeBytes(preset, R"({"prune": {"length": 0.1}})");
  const std::string before = bytesOf(preset);
  expectRefusal(runProgram({"answer", scan_, "--oracle", truth_, "--answers", "0", "--preset",
                            preset, "--json", preset}),
                1, {"preset.json: is what is read, and would be replaced"});
  EXPECT_EQ(bytesOf(preset), before);
  std::filesystem::create_symlink(preset, file("link.mtg"));
  expectRefusal(runProgram({"answer", scan_, "--oracle", truth_, "--answers", "0", "--preset",
                            preset, "-o", file("link.mtg")}),
                1, {"link.mtg: is what is read, and would be replaced"});
  EXPECT_EQ(bytesOf(preset), before);
}

TEST_F(Answer, WouldBeAskedForByTheNumbersOfAReconstruction) {
  run({"reconstruct", scan_, "--set", "prune.length=25sp", "-o", file("tree.mtg"), "--json",
       file("tree.json")}); // so that branches are missing
  const auto inDoubt = nlohmann::json::parse(bytesOf(file("tree.json")))["in_doubt"];
  EXPECT_GT(inDoubt["expected_right"], 0.8);
  EXPECT_LE(inDoubt["expected_right"], 1);
  ASSERT_EQ(inDoubt["doubts"].size(), inDoubt["count"]);
  ASSERT_GT(inDoubt["doubts"].size(), 3U);
  const auto& first = inDoubt["doubts"].front();
  EXPECT_GE(first["gain"], inDoubt["doubts"].back()["gain"]);
  EXPECT_EQ(first["alternatives"][first["present"].get<std::size_t>()]["kind"], "as_it_is");
}

TEST_F(Answer, RefusesWhatItCannotDo) {
  expectRefusal(runProgram({"answer", scan_}), 2, {"--oracle"});
  expectRefusal(runProgram({"answer", scan_, "--oracle", truth_, "--order", "size"}), 2,
                {"--order", "gain"});
  expectRefusal(runProgram({"answer", scan_, "--oracle", truth_, "--answers", "-1"}), 2,
                {"--answers"});
  for (const char* distance : {"nan", "inf", "0", "-1"})
    expectRefusal(runProgram({"answer", scan_, "--oracle", truth_, "--distance", distance}), 2,
                  {"--distance"});
  for (const char* seed : {"-1", "0.5"})
    expectRefusal(runProgram({"answer", scan_, "--oracle", truth_, "--seed", seed}), 2, {"--seed"});
  expectRefusal(runProgram({"answer", scan_, "--oracle", file("none.mtg")}), 1, {"none.mtg"});
}

} // namespace
} // namespace espalier
