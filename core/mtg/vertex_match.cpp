#include "core/mtg/vertex_match.h"

#include "core/mtg/mtg_lines.h"
#include "core/mtg/sequence_match.h"

#include <map>
#include <string>
#include <utility>

namespace espalier {
namespace {

constexpr std::size_t mostDifferences = 1000;

/// What is said of a vertex, as a text: not where it is attached, but for the label there.
std::string keyOf(const Mtg& mtg, const MtgVertex& vertex, bool withParent) {
  std::string key = std::to_string(vertex.scale) + mtgLabel(vertex) + '\t' + vertex.alias + '\t';
  if (vertex.parent && withParent)
    key += static_cast<char>(vertex.edge) + mtgLabel(mtg.vertices[indexOf(*vertex.parent)]);
  for (std::size_t i = 0; i < vertex.values.size(); ++i)
    if (!vertex.values[i].empty())
      key += '\t' + mtg.features[i].name + '=' + mtgCellText(vertex.values[i], mtg.features[i]);
  return key;
}

/// The same keys are the same numbers in both.
struct Keys {
  std::vector<int> file;
  std::vector<int> edited;

  Keys(const Mtg& fileMtg, const Mtg& editedMtg, bool withParents) {
    std::map<std::string, int> known;
    for (const auto& [mtg, numbers] : {std::pair(&fileMtg, &file), std::pair(&editedMtg, &edited)})
      for (const MtgVertex& vertex : mtg->vertices) {
        const int next = static_cast<int>(known.size());
        numbers->push_back(known.emplace(keyOf(*mtg, vertex, withParents), next).first->second);
      }
  }
};

/// Finds out which vertex is which.
class Matcher {
public:
  Matcher(const Mtg& file, const Mtg& edited)
      : file_(file), edited_(edited), whole_(file, edited, true),
        own_(file, edited, false), match_{
                                       std::vector<std::optional<VertexId>>(edited.vertices.size()),
                                       std::vector<std::optional<VertexId>>(
                                           file.vertices.size())} {}

  /// First those that both have as they are, then those between.
  std::optional<VertexMatch> match() {
    const auto pairs = matchSequences(whole_.file, whole_.edited, mostDifferences);
    if (!pairs) return std::nullopt;
    std::size_t fileStart = 0;
    std::size_t editedStart = 0;
    for (const auto& [a, b] : *pairs) {
      joinBetween(fileStart, a, editedStart, b);
      join(a, b);
      fileStart = a + 1;
      editedStart = b + 1;
    }
    joinBetween(fileStart, file_.vertices.size(), editedStart, edited_.vertices.size());
    return match_;
  }

private:
  void join(std::size_t a, std::size_t b) {
    if (file_.vertices[a].scale != edited_.vertices[b].scale) return;
    match_.after[a] = VertexId{static_cast<std::uint32_t>(b)};
    match_.before[b] = VertexId{static_cast<std::uint32_t>(a)};
  }

  /// As many vertices in both were changed; else some are the same but for their parents.
  void joinBetween(std::size_t a, std::size_t aEnd, std::size_t b, std::size_t bEnd) {
    if (aEnd - a == bEnd - b) {
      for (; a < aEnd; ++a, ++b)
        join(a, b);
      return;
    }
    const auto part = [](const std::vector<int>& keys, std::size_t from, std::size_t to) {
      return std::vector<int>(keys.begin() + static_cast<std::ptrdiff_t>(from),
                              keys.begin() + static_cast<std::ptrdiff_t>(to));
    };
    const auto pairs =
        matchSequences(part(own_.file, a, aEnd), part(own_.edited, b, bEnd), mostDifferences);
    if (!pairs) return;
    for (const auto& [i, j] : *pairs)
      join(a + i, b + j);
  }

  const Mtg& file_;
  const Mtg& edited_;
  Keys whole_;
  Keys own_; // without what a vertex is attached to
  VertexMatch match_;
};

} // namespace

std::optional<VertexMatch> matchVertices(const Mtg& file, const Mtg& edited) {
  return Matcher(file, edited).match();
}

} // namespace espalier
