#include "tests/support/manual.h"

#include "tests/support/shared_data.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

namespace espalier::test {
namespace {

std::string textOfChapter(const std::string& file) {
  std::ifstream in(sourceFolder() / "resources/manual" / file);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

std::vector<std::string> manualFiles() {
  const std::string list = textOfChapter("README.md");
  const std::regex link(R"(\n- \[[^\]]+\]\(([a-z0-9-]+\.md)\))");
  std::vector<std::string> files{"README.md"};
  for (std::sregex_iterator at(list.begin(), list.end(), link), end; at != end; ++at)
    if (std::filesystem::exists(sourceFolder() / "resources/manual" / (*at)[1].str()))
      files.push_back((*at)[1]);
  return files;
}

std::string manualText() {
  std::string all;
  for (const std::string& file : manualFiles())
    all += textOfChapter(file) + '\n';
  return all;
}

} // namespace espalier::test
