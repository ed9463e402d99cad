#include "app/report/comparison_colors.h"

#include "ui/document/difference_look.h"

#include <QCoreApplication>

namespace espalier {

NodeColors comparisonColors(const std::vector<Difference>& kinds) {
  Legend legend{.id = comparisonColorId,
                .title = QCoreApplication::translate("Differences", "Comparison"),
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
