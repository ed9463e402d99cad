// Methods and options are described in core/pipeline alone, which these tests read.
#include "core/pipeline/check_table.h"
#include "core/pipeline/presets.h"
#include "core/pipeline/registry.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace espalier {
namespace {

struct Source {
  std::string path; // from the root of the sources
  std::string text;
};

std::vector<Source> sources() {
  std::vector<Source> found;
  for (const char* top : {"core", "ui", "app"})
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(test::sourceFolder() / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      std::ifstream in(entry.path());
      found.push_back({entry.path().lexically_relative(test::sourceFolder()).string(),
                       {std::istreambuf_iterator<char>(in), {}}});
    }
  return found;
}

/// Where methods are described; and the presets, which set options as people do.
bool describesMethods(const std::string& path) {
  static const std::regex describing("core/pipeline/(\\w+_methods|method_parts|presets)\\.\\w+");
  return std::regex_match(path, describing);
}

/// All methods and options of all steps.
const std::set<std::string>& names() {
  static const std::set<std::string> all = [] {
    std::set<std::string> found;
    for (const Step& step : pipelineSteps())
      for (const Method& method : step.methods) {
        found.insert(method.name);
        for (const Option& option : method.options)
          found.insert(option.name);
      }
    return found;
  }();
  return all;
}

bool isPartOfAName(const std::string& text) {
  return std::ranges::any_of(
      names(), [&](const std::string& name) { return name.find(text) != std::string::npos; });
}

/// What `pattern` finds as its first group in the code of a file, without comments.
std::vector<std::string> foundIn(const Source& source, const std::string& pattern) {
  static const std::regex comment("//[^\n]*");
  const std::string code = std::regex_replace(source.text, comment, "");
  const std::regex wanted(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator at(code.begin(), code.end(), wanted), end; at != end; ++at)
    found.push_back((*at)[1]);
  return found;
}

// Names of one word, as "length", are keys of results, too: those are looked for where code asks.
TEST(DescribedOnce, NobodyAsksForAMethodOrOptionByItsName) {
  const std::string word = "\"(\\w+)\"";
  for (const Source& source : sources()) {
    if (describesMethods(source.path)) continue;
    for (const std::string& text : foundIn(source, word))
      EXPECT_FALSE(text.find('_') != std::string::npos && names().contains(text))
          << source.path << " names \"" << text << '"';
    if (source.text.find("#include \"core/pipeline/") == std::string::npos) continue;
    for (const std::string& asking :
         {"[=!]=\\s*" + word, word + "\\s*[=!]=", "[nN]amed\\([^\"()]*" + word,
          "\\b(?:value|has|find|at|contains|valueOf|optionOfChosen)\\([^\"()]*" + word})
      for (const std::string& text : foundIn(source, asking))
        EXPECT_FALSE(names().contains(text)) << source.path << " asks for \"" << text << '"';
    for (const std::string& text : foundIn(source, "(?:ends|starts)_with\\(" + word))
      EXPECT_FALSE(isPartOfAName(text)) << source.path << " asks for \"" << text << '"';
  }
}

/// What stands in Shown::tr(), its parts joined.
std::set<std::string> markedTexts() {
  static const std::regex marked("Shown::tr\\(\\s*((?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)\\)");
  static const std::regex between("\"\\s*\"");
  std::set<std::string> texts;
  for (const Source& source : sources())
    for (std::sregex_iterator at(source.text.begin(), source.text.end(), marked), end; at != end;
         ++at) {
      const std::string joined = std::regex_replace((*at)[1].str(), between, "");
      texts.insert(joined.substr(1, joined.rfind('"') - 1));
    }
  return texts;
}

// lupdate sees what stands in Shown::tr() alone.
TEST(DescribedOnce, EveryLabelAndHelpCanBeTranslated) {
  const std::set<std::string> marked = markedTexts();
  const auto expectMarked = [&](const std::string& label, const std::string& help) {
    EXPECT_TRUE(marked.contains(label)) << label;
    EXPECT_TRUE(marked.contains(help)) << help;
  };
  for (const Step& step : pipelineSteps()) {
    expectMarked(step.label, step.help);
    for (const Method& method : step.methods) {
      expectMarked(method.label, method.help);
      if (!method.inManual.empty()) expectMarked(method.label, method.inManual);
      for (const Option& option : method.options)
        expectMarked(option.label, option.help);
    }
  }
  for (const Option& option : checkTable().descriptions())
    expectMarked(option.label, option.help);
  for (const NamedPreset& preset : presets())
    expectMarked(preset.label, preset.help);
}

} // namespace
} // namespace espalier
