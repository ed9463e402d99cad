#include "ui/panels/coverage_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace espalier {

QString percentText(const ReviewCoverage& seen, ReviewState state, int decimals) {
  const std::size_t nodes = seen.nodes[static_cast<std::size_t>(state)];
  const double steps = std::pow(10, decimals); // in one percent
  double percent = std::floor(100 * steps * seen.share(state)) / steps;
  if (nodes == seen.totalNodes())
    percent = nodes > 0 ? 100 : 0;
  else
    percent = std::min(percent, 100 - 1 / steps);
  return QString::number(percent, 'f', decimals);
}

QString amountText(const ReviewCoverage& seen, ReviewState state, LengthUnit unit) {
  constexpr double leastShare = 0.0005; // less than a tenth of a percent is missing
  const auto at = static_cast<std::size_t>(state);
  if (seen.nodes[at] > 0 && seen.length[at] <= leastShare * seen.totalLength())
    return nodesText(seen.nodes[at]);
  return formatLength(seen.length[at], unit, 3);
}

namespace {
struct CoverageText {
  Q_DECLARE_TR_FUNCTIONS(CoverageText)
};
} // namespace

QString nodesText(std::size_t nodes) {
  return nodes == 1 ? CoverageText::tr("1 node")
                    : CoverageText::tr("%1 nodes").arg(formatCount(nodes));
}

} // namespace espalier
