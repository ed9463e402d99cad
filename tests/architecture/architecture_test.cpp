// Keeps the arrows between rooms, by reading the #include lines of all sources.
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace espalier {
namespace {

struct Include {
  std::string file;   // that includes, from the root of the sources
  std::string target; // what stands between the quotes or brackets
};

const std::vector<Include>& allIncludes() {
  static const std::vector<Include> includes = [] {
    std::vector<Include> found;
    for (const char* top : {"core", "ui", "app"})
      for (const auto& entry :
           std::filesystem::recursive_directory_iterator(test::sourceFolder() / top)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp") continue;
        std::ifstream in(entry.path());
        const std::string file = entry.path().lexically_relative(test::sourceFolder()).string();
        for (std::string line; std::getline(in, line);) {
          const std::size_t begin = line.find_first_of("<\"");
          if (!line.starts_with("#include") || begin == std::string::npos) continue;
          found.push_back(
              {file, line.substr(begin + 1, line.find_first_of(">\"", begin + 1) - begin - 1)});
        }
      }
    return found;
  }();
  return includes;
}

/// The first `depth` folders of a path: "core/graph".
std::string room(const std::string& path, int depth) {
  std::size_t end = 0;
  for (int i = 0; i < depth && end != std::string::npos; ++i)
    end = path.find('/', end + (i > 0));
  return path.substr(0, end);
}

/// What each room of core may include, besides itself: DESIGN.md, "Rooms".
std::map<std::string, std::set<std::string>> allowedInCore() {
  const std::vector<std::vector<std::string>> layers = {{"base"},
                                                        {"cloud"},
                                                        {"graph"},
                                                        {"contract", "skeleton"},
                                                        {"reconstruct", "radius", "surface", "mtg"},
                                                        {"simulate", "evaluate"},
                                                        {"pipeline"},
                                                        {"io", "project"}};
  std::map<std::string, std::set<std::string>> allowed;
  std::set<std::string> below;
  for (const std::vector<std::string>& layer : layers) {
    for (const std::string& name : layer)
      allowed["core/" + name] = below;
    for (const std::string& name : layer)
      below.insert("core/" + name);
  }
  return allowed;
}

TEST(Architecture, RoomsOfCoreUseOnlyThoseBelowThem) {
  const auto allowed = allowedInCore();
  for (const Include& include : allIncludes()) {
    if (!include.file.starts_with("core/") || !include.target.starts_with("core/")) continue;
    const std::string from = room(include.file, 2);
    const std::string to = room(include.target, 2);
    ASSERT_TRUE(allowed.contains(from)) << include.file << " is in a room nobody knows";
    EXPECT_TRUE(from == to || allowed.at(from).contains(to))
        << include.file << " includes " << include.target;
  }
}

TEST(Architecture, CoreKnowsNoQtAndNoVtk) {
  for (const Include& include : allIncludes())
    if (include.file.starts_with("core/")) {
      EXPECT_FALSE(include.target.starts_with("Q") || include.target.starts_with("vtk") ||
                   include.target.starts_with("ui/") || include.target.starts_with("app/"))
          << include.file << " includes " << include.target;
    }
}

TEST(Architecture, UiKnowsNoApp) {
  for (const Include& include : allIncludes())
    if (include.file.starts_with("ui/")) {
      EXPECT_FALSE(include.target.starts_with("app/"))
          << include.file << " includes " << include.target;
    }
}

// document <- {jobs, tools, view, panels, dialogs, plots}; these meet only in app/window.
TEST(Architecture, RoomsOfUiMeetOnlyInTheWindow) {
  for (const Include& include : allIncludes()) {
    if (!include.file.starts_with("ui/") || !include.target.starts_with("ui/")) continue;
    const std::string from = room(include.file, 2);
    const std::string to = room(include.target, 2);
    EXPECT_TRUE(from == to || to == "ui/document")
        << include.file << " includes " << include.target;
  }
}

// report <- {cli, window}, which know nothing of each other.
TEST(Architecture, RoomsOfAppShareTheReportAlone) {
  for (const Include& include : allIncludes()) {
    if (!include.file.starts_with("app/") || !include.target.starts_with("app/")) continue;
    const std::string from = room(include.file, 2);
    const std::string to = room(include.target, 2);
    EXPECT_TRUE(from == to || to == "app/report" || include.file == "app/main.cpp")
        << include.file << " includes " << include.target;
  }
}

TEST(Architecture, LibrariesAreNamedInTheirRoomsOnly) {
  // How an include begins -> how the paths of files that may have it begin.
  const std::vector<std::pair<std::string, std::vector<std::string>>> rules = {
      {"nanoflann", {"core/base/"}},  {"OpenMesh/", {}}, // for checks in tests
      {"pugixml", {"core/io/"}},      {"zlib", {"core/io/mat_file."}},
      {"sqlite3", {"core/project/"}}, {"vtk", {"ui/view/"}},
      {"CLI/", {"app/cli/"}},         {"libqhull", {"core/base/qhull."}},
      {"xxhash", {"core/project/"}},  {"liblzf/", {"core/io/lzf."}}};
  for (const Include& include : allIncludes())
    for (const auto& [library, places] : rules) {
      if (!include.target.starts_with(library)) continue;
      const bool isAllowed = std::any_of(places.begin(), places.end(), [&](const auto& place) {
        return include.file.starts_with(place);
      });
      EXPECT_TRUE(isAllowed) << include.file << " includes " << include.target;
    }
}

TEST(Architecture, ReadsTheSourcesItJudges) {
  EXPECT_GT(allIncludes().size(), 300U);
}

} // namespace
} // namespace espalier
