#include "core/base/progress.h"

#include <mutex>
#include <utility>

namespace espalier {

struct Progress::Shared {
  std::mutex mutex;
  Report report;
  double last = -1;
  std::string lastStage;
};

Progress::Progress(std::stop_token stop, Report report)
    : stop_(std::move(stop)), shared_(std::make_shared<Shared>()) {
  shared_->report = std::move(report);
}

void Progress::check() const {
  if (stop_.stop_requested()) throw Cancelled{};
}

void Progress::update(double fraction) const {
  check();
  if (!shared_ || !shared_->report) return;
  const std::scoped_lock lock(shared_->mutex);
  const double whole = from_ + (to_ - from_) * fraction;
  constexpr double smallestStep = 1.0 / 256;
  const bool staysQuiet = whole < shared_->last + smallestStep && stage_ == shared_->lastStage;
  if (whole < shared_->last || (staysQuiet && whole < 1)) return;
  shared_->last = whole;
  shared_->lastStage = stage_;
  shared_->report(whole, stage_);
}

Progress Progress::part(double from, double to, std::string_view stage) const {
  Progress result = *this;
  result.from_ = from_ + (to_ - from_) * from;
  result.to_ = from_ + (to_ - from_) * to;
  if (!stage.empty()) result.stage_ = stage;
  return result;
}

} // namespace espalier
