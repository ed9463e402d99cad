#include "ui/panels/time_left.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace espalier {

std::optional<double> secondsLeft(double elapsed, double fraction) {
  if (elapsed < 1 || fraction < 0.02) return std::nullopt; // too early to estimate
  return elapsed * (1 - fraction) / fraction;
}

QString describeTimeLeft(std::optional<double> seconds) {
  if (!seconds) return {};
  if (*seconds < 90)
    return QCoreApplication::translate("jobs", "about %1 s left")
        .arg(std::max(1.0, std::ceil(*seconds)));
  return QCoreApplication::translate("jobs", "about %1 min left").arg(std::round(*seconds / 60));
}

} // namespace espalier
