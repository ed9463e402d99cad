#include "app/report/comparison_colors.h"

#include "ui/document/difference_look.h"

#include <QCoreApplication>

namespace espalier {

namespace {
struct ComparisonColors {
  Q_DECLARE_TR_FUNCTIONS(ComparisonColors)
};
} // namespace

NodeColors comparisonColors(const std::vector<Difference>& kinds, const QString& with) {
  const QString other = with.isEmpty() ? ComparisonColors::tr("the reference") : with;
  Legend legend{.id = comparisonColorId,
                .title = ComparisonColors::tr("Compared with %1").arg(other),
                .unit = {}};
  for (const Difference kind :
       {Difference::matched, Difference::missed, Difference::invented, Difference::wronglyAttached})
    legend.categories.push_back({titleOf(kind), colorOf(kind)});
  NodeColors colors{.values = {}, .legend = std::move(legend)};
  colors.values.reserve(kinds.size());
  for (const Difference kind : kinds)
    colors.values.push_back(static_cast<float>(kind));
  return colors;
}

} // namespace espalier
