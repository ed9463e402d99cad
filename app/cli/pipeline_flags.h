#pragma once

#include "app/cli/read_flags.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "core/pipeline/pipeline.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace espalier {

/// The flags that reconstruct, contract and batch share.
struct PipelineFlags {
  std::string scan;
  ReadFlags read; // which of its points
  std::string output;
  std::string method;
  std::vector<std::string> settings; // STEP.OPTION=VALUE
  std::string preset;
  std::string root = "lowest";
  UpAxis up = UpAxis::z;
  std::string unit;
  MtgStyle mtgStyle = MtgStyle::plantNode;
  std::string json;
  int threads = 0;

  /// @param result what the output file holds, for the help
  void addTo(CLI::App& command, const std::string& result);

  /// Adds --root.
  void addRootTo(CLI::App& command);

  /// Adds those that set how a plant is reconstructed, whichever it is, and --unit.
  void addOptionsTo(CLI::App& command);

  [[nodiscard]] double meters() const; // in the unit of the scan; 0: not known

  /// @throws Error naming the flag, what it holds and what it may hold
  [[nodiscard]] PipelineOptions options(const std::string& stepOfMethod) const;
};

/// Holds loops to `threads` threads while it lives; 0 = all there are.
class Threads {
public:
  explicit Threads(int threads);
  ~Threads();
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

private:
  struct Limit;
  std::unique_ptr<Limit> limit_;
};

} // namespace espalier
