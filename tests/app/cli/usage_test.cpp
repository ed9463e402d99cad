// Wrong usage is reported in one line that names what is wrong and where help is; exit status 2.
// Names and values of options that no scan is needed to judge are refused before the scan is read.
#include "tests/app/cli/program.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <gmock/gmock.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using test::expectRefusal;
using test::namesIn;
using test::runProgram;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(Usage, AMissingArgumentIsNamed) {
  expectRefusal(runProgram({"reconstruct"}), 2,
                {"SCAN is required", "see \"espalier reconstruct --help\""});
  expectRefusal(runProgram({"reconstruct", "a.ply"}), 2, {"--output is required"});
  expectRefusal(runProgram({"evaluate", "a.mtg"}), 2, {"REFERENCE is required"});
  expectRefusal(runProgram({"convert", "a.ply"}), 2, {"OUTPUT is required"});
  expectRefusal(runProgram({"reconstruct", "a.ply", "-o"}), 2, {"--output needs a value"});
}

TEST(Usage, AnArgumentTooManyIsNamed) {
  expectRefusal(runProgram({"info", "a.ply", "b.ply"}), 2,
                {"b.ply is not expected here", "see \"espalier info --help\""});
  expectRefusal(runProgram({"info", "a.ply", "--bogus"}), 2, {"--bogus is no option; see"});
  expectRefusal(runProgram({"sweep", "s.ply", "contract.radius", "-o", "a.mtg"}), 2,
                {"-o is no option; see \"espalier sweep --help\""});
  expectRefusal(runProgram({"register", "a.ply", "b.ply", "-o", "c.ply", "--structure", "a.mtg"}),
                2, {"--structure needs 2 values, and is given 1; see"});
}

TEST(Usage, ASubcommandOrOptionNobodyKnowsIsNamed) {
  expectRefusal(runProgram({"reconstrct", "a.ply"}), 2,
                {"'reconstrct' is no file, subcommand or option: did you mean reconstruct?",
                 "see \"espalier --help\""});
  expectRefusal(runProgram({"pine", "a.ply"}), 2, {"'pine' is no file, subcommand or option; see"});
  expectRefusal(runProgram({"--bogus"}), 2, {"'--bogus' is no file, subcommand or option"});
}

TEST(Usage, TheEditorNeedsADisplay) {
  const std::vector<std::string> parts = {"no display for the editor", "use a subcommand"};
  expectRefusal(runProgram({}), 1, parts);
  expectRefusal(runProgram({test::sample("young_tree.ply")}), 1, parts);
}

TEST(Usage, TheEditorTakesNoOptions) {
  expectRefusal(test::runWith("QT_QPA_PLATFORM=offscreen",
                              {test::sample("young_tree.ply"), "--reference", "a.mtg"}),
                2, {"the editor takes files, and no option --reference", "name a subcommand"});
}

TEST(Usage, PointsAreNotColoredByWhatTheyDoNotHave) {
  expectRefusal(runProgram({"picture", test::sample("young_tree.ply"), "-o",
                            (test::freshFolder() / "a.png").string(), "--color", "rgb"}),
                2, {"have no colors", "choose another --color"});
}

TEST(Usage, AMistypedOptionIsReportedWithTheOneThatWasMeant) {
  expectRefusal(runProgram({"reconstruct", "a.ply", "--ouptut", "a.mtg"}), 2,
                {"--ouptut is no option: did you mean --output?", "espalier reconstruct --help"});
  expectRefusal(runProgram({"reconstruct", "a.ply", "-o", "a.mtg", "--seet", "contract.radius=1"}),
                2, {"--seet is no option: did you mean --set?"});
  expectRefusal(runProgram({"reconstruct", "--thread=2", "a.ply", "-o", "a.mtg"}), 2,
                {"--thread is no option: did you mean --threads?"});
  expectRefusal(runProgram({"reconstruct", "a.ply", "-o", "a.mtg", "--foo"}), 2,
                {"--foo is no option; see"}); // --root is far off
}

TEST(Usage, ADisplayThatNobodyServesIsReported) {
  expectRefusal(test::runWith("DISPLAY=:987", {}), 1,
                {"cannot open the display :987", "use a subcommand"});
}

TEST(Usage, AValueOutOfRangeIsReportedWithTheRange) {
  const auto expect = [](const test::Arguments& arguments, const std::string& advice) {
    SCOPED_TRACE(advice);
    expectRefusal(runProgram(arguments), 2, {advice, "--help"});
  };
  expect({"reconstruct", "a.ply", "-o", "b.mtg", "--threads", "0"},
         "--threads: '0' is given: choose a whole number from 1 to 1024");
  expect({"reconstruct", "a.ply", "-o", "b.mtg", "--up", "w"},
         "--up: 'w' is given: choose one of x, y, z");
  expect({"reconstruct", "a.ply", "-o", "b.mtg", "--unit", "ell"},
         "--unit: 'ell' is given: choose one of mm, cm, m");
  expect({"simulate", "-o", "a", "--points", "1.5"},
         "--points: '1.5' is given: choose a whole number from 10 to 100000000");
  expect({"simulate", "-o", "a", "--seed", "-1"}, "--seed: '-1' is given: choose a whole number");
  expect({"simulate", "-o", "a", "--noise", "nan"},
         "'nan' is given: choose a number of at least 0");
  expect({"evaluate", "a.mtg", "b.mtg", "--distance", "5mm"},
         "--distance: '5mm' is given: choose a number above 0; see");
  expect({"answer", "a.ply", "--oracle", "b.mtg", "--answers", "-1"},
         "--answers: '-1' is given: choose a whole number from 0 to 100000");
  expect({"simulate", "-o", "a", "--strays", "0.6"}, "choose a number from 0 to 0.5");
  expect({"simulate", "-o", "a", "--architecture", "moss"},
         "choose one of broadleaf, conifer, shrub, herb");
  expect({"picture", "a.ply", "-o", "b.png", "--width", "15"},
         "--width: '15' is given: choose a whole number from 16 to 16384");
  expect({"picture", "a.ply", "-o", "b.png", "--layers", "points,leaves"},
         "--layers: 'leaves' is given: choose one of points, skeleton");
}

TEST(Settings, ThatNameNothingAreRefusedBeforeTheScanIsRead) {
  const auto expect = [](const std::string& setting, const std::vector<std::string>& parts) {
    SCOPED_TRACE(setting);
    expectRefusal(runProgram({"reconstruct", "missing.ply", "-o", "missing.mtg", "--set", setting}),
                  2, parts);
  };
  expect("contract", {"\"contract\" sets nothing", "STEP.OPTION=VALUE"});
  expect("bend.radius=1", {"no step \"bend\"", "choose one of crop, values"});
  expect("contract.bend=1", {"no option \"bend\"", "choose one of neighbors, radius"});
  expect("contract.radius=wide", {"contract.radius must be a number", "not 'wide'"});
  expect("contract.method=bend", {"no method \"bend\" for step contract", "geodesic_centroid"});
}

TEST(Settings, OutOfTheRangeOfTheScanAreRefusedWithIt) {
  const fs::path folder = test::freshFolder();
  const auto expect = [&](const std::string& setting, const std::vector<std::string>& parts) {
    SCOPED_TRACE(setting);
    expectRefusal(runProgram({"reconstruct", test::sample("young_tree.ply"), "-o",
                              (folder / "a.mtg").string(), "--set", setting}),
                  1, parts);
  };
  expect("contract.radius=1000",
         {"young_tree.ply: contract.radius is 1000: choose a value from", "the points are 0.0"});
  expect("contract.neighbors=7.5", {"contract.neighbors is 7.5: choose a whole number from 3 to"});
  EXPECT_THAT(namesIn(folder), IsEmpty());
}

TEST(Settings, AMethodNobodyKnowsIsRefused) {
  expectRefusal(runProgram({"contract", "missing.ply", "-o", "a.ply", "--method", "bend"}), 2,
                {"no method \"bend\" for step contract", "geodesic_centroid"});
  expectRefusal(runProgram({"methods", "bend"}), 2, {"no step or method \"bend\"", "lists all"});
}

TEST(Settings, ARootThatIsNoPlaceIsRefused) {
  for (const char* place : {"1,2", "1,2,3,4", "a,b,c", "1,2,nan", "highest"}) {
    SCOPED_TRACE(place);
    expectRefusal(runProgram({"reconstruct", "missing.ply", "-o", "a.mtg", "--root", place}), 2,
                  {place, "write lowest, or three numbers as X,Y,Z"});
  }
}

TEST(Settings, ABadPresetIsNamed) {
  const fs::path folder = test::freshFolder();
  const std::string preset = (folder / "preset.json").string();
  const auto expect = [&](const std::string& text, const std::string& advice) {
    SCOPED_TRACE(text);
    test::writeBytes(preset, text);
    expectRefusal(runProgram({"reconstruct", "missing.ply", "-o", (folder / "a.mtg").string(),
                              "--preset", preset}),
                  1, {"preset.json, line ", advice});
    EXPECT_THAT(namesIn(folder), ElementsAre("preset.json"));
  };
  expect("", "a preset is a JSON object of steps, such as");
  expect(R"({"contract": {"radius": 1)", "a preset is a JSON object of steps, such as");
  expect("[1, 2]", "a preset is a JSON object of steps, such as");
  expect(R"({"contract": 1})", R"("contract" must hold an object of options)");
  expect(R"({"contract": {"radius": "wide"}})",
         "contract.radius must be a number, or a length as '6 spacings'");
  expect(R"({"contract": {"bend": 1}})", R"(no option "bend": choose one of)");
  expect("{\n\"prune\": {\"length\": 70},\n\"contract\": {\n\"radius\": \"wide\"}}",
         "line 4: contract.radius must be");
  expect(R"({"bend": {}})", R"(no step "bend": choose one of)");
  expect(R"({"contract": {"method": "bend"}})", R"(no method "bend" for step contract: choose)");
}

TEST(Usage, SettingsDoNotSwallowTheScanBehindThem) {
  const fs::path folder = test::freshFolder();
  const auto outcome =
      runProgram({"reconstruct", "--set", "contract.neighbors=8", "--set", "prune.method=none",
                  test::sample("young_tree.ply"), "-o", (folder / "a.mtg").string()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto picture = runProgram({"picture", "--layers", "skeleton", (folder / "a.mtg").string(),
                                   "-o", (folder / "a.png").string(), "--width", "64"});
  EXPECT_EQ(picture.status, 0) << picture.err;
}

} // namespace
} // namespace espalier
