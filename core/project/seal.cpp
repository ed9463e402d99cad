#include "core/project/seal.h"

#include "core/base/shown_message.h"
#include "core/project/structure_hash.h"
#include "core/skeleton/review_coverage.h"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <utility>

namespace espalier {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format = "espalier seal 1";

std::string hexOf(std::uint64_t value) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value));
  return text.data();
}

std::uint64_t fromHex(const std::string& text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, value, 16);
  if (text.size() != 16 || stop != end || failed != std::errc())
    throw ShownError(
        {espalier::Shown::tr("the seal has no hash that can be read: sign the structure again")});
  return value;
}

/// ISO 8601, for people.
std::string dateOf(std::int64_t time) {
  using namespace std::chrono;
  const sys_time<milliseconds> point{milliseconds(time)};
  const auto day = floor<days>(point);
  const year_month_day date(day);
  const hh_mm_ss clock(floor<seconds>(point - day));
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02uT%02d:%02d:%02dZ", int(date.year()),
                unsigned(date.month()), unsigned(date.day()), int(clock.hours().count()),
                int(clock.minutes().count()), int(clock.seconds().count()));
  return text.data();
}

bool isBlank(const std::string& text) {
  return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

Json jsonOf(const ReviewRecord& record) {
  const auto amount = [](const ReviewRecord::Amount& each) {
    return Json{{"nodes", each.nodes}, {"length", each.length}};
  };
  return {{"looked_at", amount(record.lookedAt)},
          {"in_bulk", amount(record.inBulk)},
          {"before", amount(record.before)},
          {"doubted", amount(record.doubted)},
          {"comments", record.comments}};
}

ReviewRecord recordFrom(const Json& json) {
  const auto amount = [&](const char* key) {
    return ReviewRecord::Amount{.nodes = json.at(key).at("nodes").get<std::size_t>(),
                                .length = json.at(key).at("length").get<double>()};
  };
  return {.lookedAt = amount("looked_at"),
          .inBulk = amount("in_bulk"),
          .before = amount("before"),
          .doubted = amount("doubted"),
          .comments = json.at("comments").get<std::size_t>()};
}

Json jsonOf(const std::optional<SealedQuestions>& questions) {
  if (!questions) return nullptr;
  return {{"answered", questions->answered},
          {"open", questions->open ? Json(*questions->open) : Json(nullptr)}};
}

std::optional<SealedQuestions> questionsFrom(const Json& json) {
  if (json.is_null()) return std::nullopt;
  const Json& open = json.at("open");
  return SealedQuestions{.answered = json.at("answered").get<std::size_t>(),
                         .open = open.is_null() ? std::nullopt
                                                : std::optional(open.get<std::size_t>())};
}

Json jsonOf(const std::optional<SealedAgreement>& agreement) {
  if (!agreement) return nullptr;
  return {{"with", agreement->with},
          {"distance", agreement->distance},
          {"precision", agreement->precision},
          {"recall", agreement->recall},
          {"f", agreement->f},
          {"structural", agreement->structural ? Json(*agreement->structural) : Json(nullptr)}};
}

std::optional<SealedAgreement> agreementFrom(const Json& json) {
  if (json.is_null()) return std::nullopt;
  const auto number = [&](const char* key) { return json.at(key).get<double>(); };
  return SealedAgreement{.with = json.at("with").get<std::string>(),
                         .distance = number("distance"),
                         .precision = number("precision"),
                         .recall = number("recall"),
                         .f = number("f"),
                         .structural = json.at("structural").is_null()
                                           ? std::nullopt
                                           : std::optional(number("structural"))};
}

Json jsonOf(const SealedState& state) {
  return {{"findings", Json(state.findings)},
          {"ignored", state.ignored},
          {"points", state.points},
          {"unexplained", state.unexplained},
          {"ignored_places", state.ignoredPlaces},
          {"ignored_points", state.ignoredPoints},
          {"questions", jsonOf(state.questions)},
          {"automatic", jsonOf(state.automatic)},
          {"other", jsonOf(state.other)},
          {"reason", state.reason}};
}

SealedState stateFrom(const Json& json) {
  return {.findings = json.at("findings").get<std::map<std::string, std::size_t>>(),
          .ignored = json.at("ignored").get<std::size_t>(),
          .points = json.at("points").get<std::size_t>(),
          .unexplained = json.at("unexplained").get<std::size_t>(),
          .ignoredPlaces = json.value("ignored_places", std::size_t{0}), // none in older ones
          .ignoredPoints = json.value("ignored_points", std::size_t{0}),
          .questions = questionsFrom(json.value("questions", Json())), // likewise
          .automatic = agreementFrom(json.at("automatic")),
          .other = agreementFrom(json.at("other")),
          .reason = json.at("reason").get<std::string>()};
}

} // namespace

std::size_t SealedState::openFindings() const {
  std::size_t sum = 0;
  for (const auto& [kind, count] : findings)
    sum += count;
  return sum;
}

Seal signedBy(const std::string& author, std::int64_t time, const History& history,
              std::optional<SealedState> state) {
  if (isBlank(author))
    throw ShownError({espalier::Shown::tr("a seal needs a name: type who signs")});
  const ReviewCoverage seen = coverage(history.skeleton);
  if (seen.totalNodes() == 0)
    throw ShownError({espalier::Shown::tr("there is no skeleton to sign: make one first")});
  if (!seen.isComplete())
    throw ShownError(
        {espalier::Shown::tr("%1 of %2 nodes are not reviewed: walk there and review them first"),
         {std::to_string(seen.totalNodes() - seen.nodes[2]), std::to_string(seen.totalNodes())}});
  const auto done = std::span(history.steps).first(history.position);
  return {.author = author,
          .time = time,
          .work = handWork(done, history.skeleton),
          .nodes = seen.totalNodes(),
          .length = seen.totalLength(),
          .hash = StructureHash(history.skeleton).value(),
          .review = reviewRecord(done, history.skeleton),
          .state = std::move(state)};
}

std::string textOf(const Seal& seal) {
  const Corrections& made = seal.work.corrections;
  Json json = {{"format", format},
               {"signed_by", seal.author},
               {"signed_at", dateOf(seal.time)},
               {"signed_at_ms", seal.time},
               {"worked_ms", seal.work.time},
               {"corrections",
                {{"edits", made.edits},
                 {"added", made.added},
                 {"removed", made.removed},
                 {"moved", made.moved},
                 {"reparented", made.reparented},
                 {"retyped", made.retyped},
                 {"radii", made.radii}}},
               {"nodes", seal.nodes},
               {"length", seal.length},
               {"hash", hexOf(seal.hash)}};
  if (seal.review) json["review"] = jsonOf(*seal.review);
  if (seal.state) json["state"] = jsonOf(*seal.state);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Seal sealFrom(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("format", Json()) != format)
    throw ShownError(
        {espalier::Shown::tr("the seal of this structure cannot be read: sign it again")});
  try {
    const Json& made = json.at("corrections");
    const auto count = [&](const char* key) { return made.at(key).get<std::size_t>(); };
    Seal seal = {.author = json.at("signed_by").get<std::string>(),
                 .time = json.at("signed_at_ms").get<std::int64_t>(),
                 .work = {.corrections = {.edits = count("edits"),
                                          .added = count("added"),
                                          .removed = count("removed"),
                                          .moved = count("moved"),
                                          .reparented = count("reparented"),
                                          .retyped = count("retyped"),
                                          .radii = count("radii")},
                          .time = json.at("worked_ms").get<std::int64_t>()},
                 .nodes = json.at("nodes").get<std::size_t>(),
                 .length = json.at("length").get<double>(),
                 .hash = fromHex(json.at("hash").get<std::string>())};
    if (json.contains("review")) seal.review = recordFrom(json["review"]);
    if (json.contains("state")) seal.state = stateFrom(json["state"]);
    return seal;
  } catch (const Json::exception&) {
    throw ShownError(
        {espalier::Shown::tr("the seal of this structure is not complete: sign it again")});
  }
}

} // namespace espalier
