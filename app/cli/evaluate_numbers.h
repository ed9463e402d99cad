#pragma once

#include "app/report/report_data.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace espalier {

/// Adds what a report shows beyond a comparison:
///
///   curve[]    distance, precision, recall, f: at even distances from 0 on
///   errors     distance, missed, invented, parts[].{kind,length,order,place}: the longest first;
///              `order` in the skeleton that the part is of, `place` of its beginning as the
///              result lies registered
///   intervals  distance, draws, confidence, seed, scores.NAME.{value,low,high}
void addMeasured(nlohmann::ordered_json& json, const ReportData& data);

/// What the numbers are of.
struct NumberedFiles {
  std::vector<std::string> results;
  std::string reference;
  std::string scan; // may be empty
  std::string unit; // of lengths; may be empty
  bool isRanking = false;
};

/// Adds who measured what:
///
///   version  of the program
///   unit     of lengths, null if it is not known
///   inputs   {result,reference,scan}.{file,sha256}; of a ranking, results[] for result
/// @throws Error if a file cannot be read
void addOrigin(nlohmann::ordered_json& json, const NumberedFiles& files);

} // namespace espalier
