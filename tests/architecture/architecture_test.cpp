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
    for (const char* top : {"core", "ui", "app", "python"})
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

/// Each room and those right below it, which are named before it.
using Rooms = std::vector<std::pair<std::string, std::vector<std::string>>>;

const Rooms roomsOfCore = {
    {"base", {}},
    {"cloud", {"base"}},
    {"graph", {"cloud"}},
    {"align", {"cloud"}},
    {"contract", {"graph"}},
    {"skeleton", {"graph"}},
    {"reconstruct", {"contract", "skeleton"}},
    {"radius", {"contract", "skeleton"}},
    {"surface", {"contract", "skeleton"}},
    {"surface/envelopes", {"surface"}},
    {"mtg", {"contract", "skeleton"}},
    {"simulate", {"reconstruct", "radius", "surface", "mtg"}},
    {"clean", {"reconstruct", "radius", "surface", "mtg"}},
    {"evaluate/match", {"reconstruct", "radius", "surface", "mtg"}},
    {"evaluate/light", {"reconstruct", "radius", "surface", "mtg"}},
    {"evaluate/traits", {"evaluate/match"}},
    {"evaluate/registration", {"evaluate/match"}},
    {"evaluate/differences", {"evaluate/match"}},
    {"evaluate",
     {"evaluate/light", "evaluate/traits", "evaluate/registration", "evaluate/differences"}},
    {"evaluate/study", {"evaluate"}},
    {"decide", {"simulate", "evaluate/study"}},
    {"pipeline", {"clean", "decide", "surface/envelopes"}},
    {"doubt", {"pipeline"}},
    {"io/bytes", {"pipeline"}},
    {"io/points", {"io/bytes"}},
    {"io/structures", {"io/bytes"}},
    {"io/plantgl", {"io/bytes"}},
    {"io/qsm", {"io/bytes"}},
    {"io", {"io/points", "io/structures", "io/plantgl", "io/qsm"}},
    {"project", {"pipeline"}},
    {"worklist", {"io", "project"}}};

const Rooms roomsOfWindow = {{"frame", {}},
                             {"files", {"frame"}},
                             {"edit", {"frame"}},
                             {"align", {"files", "edit"}},
                             {"view", {"edit"}},
                             {"evaluate", {"files", "edit"}},
                             {"review", {"files", "edit"}},
                             {"preview", {"view", "evaluate"}},
                             {"", {"preview", "review", "align"}}};

/// The folder of a file, from `top` on: "graph" of "core/graph/geodesic.h".
std::string room(const std::string& file, const std::string& top) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  return folder == top ? "" : folder.substr(top.size() + 1);
}

void expectArrowsDownward(const std::string& top, const Rooms& rooms) {
  std::map<std::string, std::set<std::string>> allowed; // room -> itself and all below it
  for (const auto& [name, below] : rooms) {
    allowed[name].insert(name);
    for (const std::string& next : below)
      allowed[name].insert(allowed.at(next).begin(), allowed.at(next).end());
  }
  for (const Include& include : allIncludes()) {
    if (!include.file.starts_with(top + "/") || !include.target.starts_with(top + "/")) continue;
    const std::string from = room(include.file, top);
    ASSERT_TRUE(allowed.contains(from)) << include.file << " is in a room nobody knows";
    EXPECT_TRUE(allowed.at(from).contains(room(include.target, top)))
        << include.file << " includes " << include.target;
  }
}

TEST(Architecture, RoomsOfCoreUseOnlyThoseBelowThem) {
  expectArrowsDownward("core", roomsOfCore);
}

TEST(Architecture, RoomsOfTheWindowUseOnlyThoseBelowThem) {
  expectArrowsDownward("app/window", roomsOfWindow);
}

TEST(Architecture, CoreKnowsNoQtAndNoVtk) {
  for (const Include& include : allIncludes())
    if (include.file.starts_with("core/")) {
      EXPECT_FALSE(include.target.starts_with("Q") || include.target.starts_with("vtk") ||
                   include.target.starts_with("ui/") || include.target.starts_with("app/"))
          << include.file << " includes " << include.target;
    }
}

TEST(Architecture, PythonKnowsCoreAloneAndNobodyKnowsPython) {
  for (const Include& include : allIncludes()) {
    const bool isOfPython = include.file.starts_with("python/");
    const bool isOfWindow = include.target.starts_with("Q") || include.target.starts_with("vtk") ||
                            include.target.starts_with("ui/") || include.target.starts_with("app/");
    EXPECT_FALSE(isOfPython ? isOfWindow : include.target.starts_with("python/"))
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
    const std::string from = room(include.file, "ui");
    const std::string to = room(include.target, "ui");
    EXPECT_TRUE(from == to || to == "document") << include.file << " includes " << include.target;
  }
}

// {about, plot, report} <- {cli, window}, which know nothing of each other, nor of the log, which
// knows about alone.
TEST(Architecture, RoomsOfAppShareAboutPlotAndReportAlone) {
  for (const Include& include : allIncludes()) {
    if (!include.file.starts_with("app/") || !include.target.starts_with("app/")) continue;
    const std::string from =
        room(include.file, "app").substr(0, room(include.file, "app").find('/'));
    const std::string to =
        room(include.target, "app").substr(0, room(include.target, "app").find('/'));
    EXPECT_TRUE(from == to || to == "about" || to == "report" || to == "plot" ||
                include.file == "app/main.cpp")
        << include.file << " includes " << include.target;
  }
}

TEST(Architecture, LibrariesAreNamedInTheirRoomsOnly) {
  // How an include begins -> how the paths of files that may have it begin.
  const std::vector<std::pair<std::string, std::vector<std::string>>> rules = {
      {"nanoflann", {"core/base/"}},
      {"OpenMesh/", {}}, // for checks in tests
      {"pugixml", {"core/io/bytes/xml."}},
      {"zlib", {"core/io/qsm/mat_file.", "ui/view/animated_png."}},
      {"sqlite3", {"core/project/"}},
      {"vtk", {"ui/view/"}},
      {"spnav", {"ui/view/space_mouse."}},
      {"CLI/", {"app/cli/"}},
      {"libqhull", {"core/base/qhull."}},
      {"xxhash", {"core/project/"}},
      {"pybind11", {"python/"}},
      {"liblzf/", {"core/io/points/lzf."}},
      // No network is ever used, as the README says. The driver of 3D mice is another program on
      // this computer.
      {"sys/socket", {"ui/view/space_mouse."}},
      {"netinet/", {}},
      {"netdb", {}},
      {"arpa/", {}},
      {"curl/", {}},
      {"QtNetwork", {}},
      {"QNetwork", {}},
      {"QTcp", {}},
      {"QUdp", {}},
      {"QSsl", {}},
      {"QWebSocket", {}}};
  for (const Include& include : allIncludes())
    for (const auto& [library, places] : rules) {
      if (!include.target.starts_with(library)) continue;
      const bool asksVersion = include.file == "app/about/libraries.cpp" && library != "vtk";
      if (asksVersion) continue;
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
