#include "core/mtg/openalea_limits.h"

#include "core/base/text.h"
#include "core/mtg/mtg_lines.h"
#include "core/mtg/mtg_rows.h"
#include "core/mtg/mtg_writer.h"

#include <algorithm>
#include <array>

namespace espalier {
namespace {

constexpr std::size_t mostNamed = 20;

/// Whether OpenAlea takes a value apart: all travels through the parser of its codes. A / parts it
/// only before a symbol, so dates are safe.
bool isTakenApart(std::string_view value, const Mtg& mtg) {
  if (value.find_first_of("+<[](),=\\") != std::string_view::npos) return true;
  for (std::size_t at = value.find('/'); at != std::string_view::npos; at = value.find('/', at + 1))
    for (const MtgClass& each : mtg.classes)
      if (!each.symbol.empty() && value.substr(at + 1).starts_with(each.symbol)) return true;
  return false;
}

void findInValues(const Mtg& mtg, std::vector<std::string>& found) {
  std::size_t values = 0;
  const auto look = [&](const std::vector<std::string>& texts, const MtgVertex& vertex) {
    for (std::size_t i = 0; i < texts.size(); ++i)
      if (isTakenApart(texts[i], mtg) && ++values <= mostNamed)
        found.push_back("the value " + inQuotes(texts[i]) + " of " + mtg.features[i].name + " at " +
                        mtgLabel(vertex) + " holds signs of codes");
  };
  for (const MtgVertex& vertex : mtg.vertices) {
    look(vertex.values, vertex);
    for (const auto& texts : vertex.later)
      look(texts, vertex);
  }
  if (values > mostNamed)
    found.push_back(std::to_string(values - mostNamed) + " more values hold signs of codes");
}

void findInFeatures(const Mtg& mtg, std::vector<std::string>& found) {
  constexpr auto types =
      std::to_array<std::string_view>({"INT", "REAL", "ALPHA", "STRING", "DD/MM/YY", "DD/MM/YYYY"});
  for (const MtgFeature& feature : mtg.features) {
    if (std::ranges::find(types, feature.type) == types.end())
      found.push_back("the type " + inQuotes(feature.type) + " of the feature " + feature.name +
                      " is not known");
    if (feature.name.find_first_of(" (),=<+/") != std::string::npos)
      found.push_back("the name of the feature " + inQuotes(feature.name) + " is no single word");
  }
}

/// OpenAlea steps from scale to scale, and has a scene of its own.
void findInScales(const Mtg& mtg, std::vector<std::string>& found) {
  std::size_t skips = 0;
  bool namesScene = false;
  for (const MtgVertex& vertex : mtg.vertices) {
    const int coarser = vertex.complex ? mtg.vertices[indexOf(*vertex.complex)].scale : 0;
    if (vertex.scale > coarser + 1) ++skips;
    if (vertex.scale == 0) namesScene = true;
  }
  if (skips > 0)
    found.push_back(std::to_string(skips) +
                    " vertices skip a scale: they are taken to be one scale finer than their unit");
  if (namesScene) found.emplace_back("the scene is a vertex: nothing can be read");
}

void findInClasses(const Mtg& mtg, std::vector<std::string>& found) {
  for (const MtgClass& each : mtg.classes)
    if (each.symbol != "$" && !std::ranges::all_of(each.symbol, isLetter))
      found.push_back("the class " + inQuotes(each.symbol) + " is not of letters alone");
}

} // namespace

std::vector<std::string> openAleaLimits(const Mtg& mtg) {
  const Mtg written = mtgAsWritten(mtg);
  std::vector<std::string> found;
  findInClasses(written, found);
  findInScales(written, found);
  findInFeatures(written, found);
  findInValues(written, found);
  if (mtgRows(written).isAmbiguous)
    found.emplace_back(
        "a vertex has three successors or more: some are taken to follow each other");
  return found;
}

} // namespace espalier
