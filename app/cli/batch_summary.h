#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace espalier {

/// What came of one plant of a batch. Numbers as the summary has them: empty where there are none.
struct BatchResult {
  std::string name;
  bool isDone = false; // false: it failed
  std::string inputs;  // hash of the scan, the reference and all that was asked for
  std::string points, spacing, nodes, tips, length, height, rootRadius; // lengths in [L]
  std::string unit;                  // of these; empty: not known
  std::string volume;                // of the wood [L^3]
  std::string stemDiameter;          // at breast height [L]; empty: none
  std::string crownArea;             // seen from above [L^2]
  std::string expectedRight, doubts; // as doubtNumbers() has them
  std::map<std::string, std::string> scores =
      {};               // by key: scoresIn(inBrief), if there is a reference
  std::string distance; // of those that take one
  std::string seconds;
  std::string problem; // why it failed
  std::vector<std::string> notes =
      {}; // of the scan, the steps and the fit, of this run; not in the file
};

/// The results of a batch, of this run and those before: DIR/summary.csv, a line per plant.
class BatchSummary {
public:
  /// Takes up what earlier runs wrote, if there is anything.
  /// @throws Error if the file is no summary, or cannot be read
  explicit BatchSummary(std::filesystem::path file);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  /// The result of a plant, if it was tried; else none.
  [[nodiscard]] const BatchResult* find(const std::string& name) const;

  /// Adds or replaces a result and writes the file, which is always whole: the plants of `order`
  /// first, then those of earlier runs that are done and not in it.
  /// @throws Error if it cannot be written
  void put(BatchResult result, const std::vector<std::string>& order);

private:
  std::filesystem::path file_;
  std::map<std::string, BatchResult> results_;
};

} // namespace espalier
