#include "app/window/align/scan_registration.h"

#include "core/base/error.h"
#include "ui/document/shown_message.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace espalier {
namespace {

constexpr std::size_t fewestPairs = 3;
constexpr std::size_t fewestToJudge = 4; // three lie on three nearly always

} // namespace

void ScanRegistration::addMoved(const Eigen::Vector3d& place) {
  assert(pending_);
  pairs_.push_back({.moved = place, .fixed = *pending_});
  pending_.reset();
  fit();
}

void ScanRegistration::removeLast() {
  assert(hasWork());
  if (pending_)
    pending_.reset();
  else if (byPoints_ && pairs_.size() <= pairsOfFit_)
    byPoints_.reset();
  else
    removePair(pairs_.size() - 1);
}

void ScanRegistration::setFit(const CloudFit& fit) {
  byPoints_ = fit;
  pairsOfFit_ = pairs_.size();
}

void ScanRegistration::removePair(std::size_t pair) {
  pairs_.erase(pairs_.begin() + static_cast<std::ptrdiff_t>(pair));
  fit();
}

void ScanRegistration::fit() {
  byPairs_.reset();
  refusal_.clear();
  if (pairs_.size() < fewestPairs) return;
  try {
    byPairs_ = fitPairs(pairs_);
    byPoints_.reset();
  } catch (const Error& error) { // as for targets on a line: another pair may mend it
    refusal_ = shownText(error).toStdString();
  }
}

Eigen::Isometry3d ScanRegistration::motion() const {
  if (byPoints_) return byPoints_->motion;
  return byPairs_ ? byPairs_->motion : start_;
}

std::vector<double> ScanRegistration::residuals() const {
  return isPlaced() ? distancesApart(pairs_, motion()) : std::vector<double>();
}

std::optional<double> ScanRegistration::rmsByPairs() const {
  return byPairs_ ? std::optional(byPairs_->rms) : std::nullopt;
}

double ScanRegistration::rms() const {
  return rmsOf(residuals());
}

std::optional<std::size_t> ScanRegistration::worst() const {
  const std::vector<double> all = residuals();
  if (all.size() < fewestToJudge) return std::nullopt;
  return static_cast<std::size_t>(std::ranges::max_element(all) - all.begin());
}

} // namespace espalier
