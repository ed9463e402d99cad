#include "app/cli/project_info.h"

#include "app/cli/statistics.h"
#include "app/cli/terminal.h"
#include "core/project/corrections.h"
#include "core/project/project.h"
#include "core/project/seal.h"
#include "core/skeleton/review_coverage.h"

#include <nlohmann/json.hpp>

#include <array>
#include <ctime>
#include <set>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

/// "2026-03-01 14:05 UTC"
std::string dateOf(std::int64_t milliseconds) {
  const auto seconds = static_cast<std::time_t>(milliseconds / 1000);
  std::tm parts{};
  std::array<char, 40> text{};
  if (::gmtime_r(&seconds, &parts) == nullptr) return "unknown";
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M UTC", &parts)};
}

Json textOrNull(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json editsOf(const History& history) {
  std::set<std::string> authors;
  for (const HistoryStep& step : history.steps)
    if (!step.author.empty()) authors.insert(step.author);
  const auto done = std::span(history.steps).first(history.position);
  return {{"done", history.position},
          {"undone", history.steps.size() - history.position},
          {"by_hand", handWork(done, history.skeleton).corrections.edits},
          {"last", history.steps.empty() ? Json(nullptr) : Json(dateOf(history.steps.back().time))},
          {"authors", authors}};
}

Json scanOf(const Project& project) {
  const std::optional<ScanReference> scan = project.scan();
  if (!scan) return nullptr;
  const auto found = project.findScan();
  return {{"file", scan->path.string()},
          {"found", found ? Json(found->string()) : Json(nullptr)},
          {"is_kept", project.hasBytes(keptCloudName)}};
}

Json reviewOf(const ReviewCoverage& review) {
  return {{"reviewed", review.share(ReviewState::reviewed)},
          {"doubtful", review.share(ReviewState::doubtful)},
          {"to_do", review.share(ReviewState::toDo)}};
}

/// A seal that cannot be read must not keep the rest from being reported.
Json sealOf(const Project& project) {
  const std::string text = project.document("seal");
  if (text.empty()) return nullptr;
  try {
    return Json::parse(textOf(sealFrom(text)));
  } catch (const Error& error) {
    printNotes({project.path().string() + ": " + error.what()});
    return nullptr;
  }
}

} // namespace

Json infoOnProject(const std::string& file) {
  const Project project = Project::open(file, Access::readOnly);
  const Imported<History> history = project.history();
  printNotes(history.notes);
  const ReviewCoverage review = coverage(history.value.skeleton);
  const std::string name = project.document("name");
  Json json = {{"plant", name.empty() ? project.path().stem().string() : name},
               {"unit", textOrNull(project.document("unit"))}};
  json.update(statistics(history.value.skeleton));
  json["edits"] = editsOf(history.value);
  json["scan"] = scanOf(project);
  json["points_set_aside"] = history.value.leftOut.size();
  json["organs_by_hand"] = history.value.organs.all().size();
  json["review"] = reviewOf(review);
  json["nodes_to_do"] = review.nodes[0];
  json["seal"] = sealOf(project);
  json["signed_by"] = json["seal"].is_null() ? Json(nullptr) : json["seal"]["signed_by"];
  json["has_mtg"] = !project.document("mtg").empty();
  json["has_reference"] = !project.document("reference").empty();
  return json;
}

} // namespace espalier
