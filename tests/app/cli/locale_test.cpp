// Numbers in files and on the command line have a point, whatever the system writes.
#include "core/io/formats.h"
#include "tests/app/cli/program.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

namespace espalier {
namespace {

namespace fs = std::filesystem;
using test::runProgram;

class Locale : public testing::Test {
protected:
  /// Makes a locale that writes 0,5; false if the system does not know how.
  [[nodiscard]] bool make(const std::string& name) const {
    const fs::path made = folder_ / "locales" / (name + ".utf8");
    fs::create_directories(made.parent_path());
    const std::string command =
        "localedef -i " + name + " -f UTF-8 '" + made.string() + "' >/dev/null 2>&1";
    static_cast<void>(std::system(command.c_str())); // NOLINT(cert-env33-c): warnings end it, too
    return fs::exists(made / "LC_NUMERIC");
  }

  void use(const std::string& locale, const std::string& language) const {
    setenv("LOCPATH", (folder_ / "locales").c_str(), 1);
    setenv("LC_ALL", locale.c_str(), 1);
    setenv("LANGUAGE", language.c_str(), 1);
  }

  ~Locale() override {
    for (const char* name : {"LOCPATH", "LC_ALL", "LANGUAGE"})
      unsetenv(name);
  }

  /// What all that writes numbers writes, by file; what is printed as files of their own.
  [[nodiscard]] std::map<std::string, std::string> written(const std::string& run) const {
    const fs::path folder = folder_ / run;
    fs::create_directory(folder);
    const auto file = [&](const std::string& name) { return (folder / name).string(); };
    const std::string scan = test::sample("young_tree.ply");
    const std::string plant = test::sample("young_tree.mtg");
    std::map<std::string, std::string> texts;
    const auto call = [&](const std::string& name, const test::Arguments& arguments) {
      const test::Outcome outcome = runProgram(arguments);
      EXPECT_EQ(outcome.status, 0) << name << ": " << outcome.err;
      texts[name] = outcome.out;
    };
    for (const Format& format : formats()) {
      const std::string to = std::string(format.name) + "." + std::string(format.extensions[0]);
      if (format.writeStructure != nullptr) call(to, {"convert", plant, file(to)});
      if (format.writePoints != nullptr)
        call("points_" + to, {"convert", scan, file("points_" + to)});
    }
    call("methods", {"methods", "--json"});
    call("info", {"info", plant});
    call("info.json", {"info", plant, "--json"});
    call("traits", {"traits", plant, "--json", file("traits.json")});
    call("simulate", {"simulate", "--seed", "3", "--points", "2000", "-o", file("grown")});
    call("evaluate",
         {"evaluate", file("grown.mtg"), plant, "--scale", "1.5", "--json", file("scores.json"),
          "--csv", file("scores.csv"), "--report", file("report.html")});
    for (const fs::directory_entry& each : fs::directory_iterator(folder))
      texts[each.path().filename().string()] = test::bytesOf(each.path());
    for (auto& [name, text] : texts) // folders are named in reports
      for (std::size_t at = 0; (at = text.find(folder.string(), at)) != std::string::npos;)
        text.replace(at, folder.string().size(), "FOLDER");
    return texts;
  }

  fs::path folder_ = test::freshFolder();
};

TEST_F(Locale, ChangesNoFileAndNothingThatIsPrinted) {
  if (!make("fr_FR") || !make("de_DE")) GTEST_SKIP() << "localedef or its locales are missing";
  use("C", "");
  const std::map<std::string, std::string> plain = written("plain");
  EXPECT_GT(plain.size(), 20U);
  for (const auto& [locale, language] : {std::pair{"fr_FR.UTF-8", "fr"}, {"de_DE.UTF-8", "de"}}) {
    use(locale, language);
    const std::map<std::string, std::string> texts = written(locale);
    ASSERT_EQ(texts.size(), plain.size());
    for (const auto& [name, text] : plain)
      EXPECT_TRUE(text == texts.at(name)) << locale << ", " << name;
  }
}

} // namespace
} // namespace espalier
