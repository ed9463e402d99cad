#include "core/project/seal.h"

#include "core/base/error.h"
#include "core/project/structure_hash.h"
#include "core/skeleton/review_coverage.h"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <chrono>
#include <cstdio>

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
    throw Error("the seal has no hash that can be read: sign the structure again");
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

} // namespace

Seal signedBy(const std::string& author, std::int64_t time, const History& history) {
  if (isBlank(author)) throw Error("a seal needs a name: type who signs");
  const ReviewCoverage seen = coverage(history.skeleton);
  if (seen.totalNodes() == 0) throw Error("there is no skeleton to sign: make one first");
  if (!seen.isComplete())
    throw Error(std::to_string(seen.totalNodes() - seen.nodes[2]) + " of " +
                std::to_string(seen.totalNodes()) +
                " nodes are not reviewed: walk there and review them first");
  return {.author = author,
          .time = time,
          .work = handWork(std::span(history.steps).first(history.position), history.skeleton),
          .nodes = seen.totalNodes(),
          .length = seen.totalLength(),
          .hash = StructureHash(history.skeleton).value()};
}

std::string textOf(const Seal& seal) {
  const Corrections& made = seal.work.corrections;
  const Json json = {{"format", format},
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
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Seal sealFrom(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("format", Json()) != format)
    throw Error("the seal of this structure cannot be read: sign it again");
  try {
    const Json& made = json.at("corrections");
    const auto count = [&](const char* key) { return made.at(key).get<std::size_t>(); };
    return {.author = json.at("signed_by").get<std::string>(),
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
  } catch (const Json::exception&) {
    throw Error("the seal of this structure is not complete: sign it again");
  }
}

} // namespace espalier
