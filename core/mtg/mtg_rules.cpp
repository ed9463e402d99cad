#include "core/mtg/mtg_rules.h"

#include "core/base/text.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace espalier {
namespace {

using AllowedLink = std::tuple<std::string, std::string, std::string>; // left, right, edge

/// All links that rules list: a right side may name several classes.
std::set<AllowedLink> linksOf(const std::vector<MtgRule>& rules) {
  std::set<AllowedLink> links;
  for (const MtgRule& rule : rules)
    for (std::size_t at = 0; at <= rule.right.size();) {
      const std::size_t end = std::min(rule.right.find(',', at), rule.right.size());
      const std::string_view right = trimmed(std::string_view(rule.right).substr(at, end - at));
      links.emplace(rule.left, std::string(right), rule.edge);
      at = end + 1;
    }
  return links;
}

} // namespace

Mtg withRulesOfNewClasses(const Mtg& base, Mtg edited) {
  if (base.rules.empty()) return edited;
  std::set<std::string> added;
  for (const MtgClass& each : edited.classes)
    if (std::ranges::find(base.classes, each.symbol, &MtgClass::symbol) == base.classes.end())
      added.insert(each.symbol);
  if (added.empty()) return edited;
  std::set<AllowedLink> known = linksOf(edited.rules);
  const auto add = [&](const std::string& left, const std::string& right, char edge) {
    if (known.emplace(left, right, std::string(1, edge)).second)
      edited.rules.push_back({left, right, std::string(1, edge), "?"});
  };
  for (const std::string& symbol : added)
    for (const char edge : {'<', '+'})
      add(symbol, symbol, edge);
  for (const MtgVertex& vertex : edited.vertices) {
    if (!vertex.parent) continue;
    const std::string& left = edited.vertices[indexOf(*vertex.parent)].symbol;
    if (added.contains(left) || added.contains(vertex.symbol))
      add(left, vertex.symbol, static_cast<char>(vertex.edge));
  }
  return edited;
}

} // namespace espalier
