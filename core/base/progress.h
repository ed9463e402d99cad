#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

namespace espalier {

/// Thrown by Progress when a stop was asked for. Not a std::exception: stopping is no error.
struct Cancelled {};

/// How a long computation reports how far it is, and learns that it should stop.
///
/// Cheap to copy; a default one reports to nobody and never stops. Safe to use from many threads:
/// reports are serialized, rise only, and come at most a few hundred times a run.
class Progress {
public:
  /// Takes the fraction done, in [0, 1], and the name of the stage.
  using Report = std::function<void(double fraction, std::string_view stage)>;

  Progress() = default;
  Progress(std::stop_token stop, Report report);

  /// @throws Cancelled if a stop was asked for
  void check() const;

  /// Reports that `fraction` of this computation, in [0, 1], is done.
  /// @throws Cancelled if a stop was asked for
  void update(double fraction) const;

  /// The progress of a part of this computation that covers [from, to] of it.
  /// An empty `stage` keeps the name of the whole.
  [[nodiscard]] Progress part(double from, double to, std::string_view stage = {}) const;

private:
  struct Shared;
  std::stop_token stop_;
  std::shared_ptr<Shared> shared_;
  double from_ = 0;
  double to_ = 1;
  std::string stage_;
};

} // namespace espalier
