#pragma once

#include "core/skeleton/skeleton.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

enum class VertexId : std::uint32_t {}; // place in Mtg::vertices

inline constexpr int finestScale = 100;       // no plant has more than ten: finer ones are damage
inline constexpr std::size_t mostScales = 32; // of one plant, which has five or six

struct MtgClass {
  std::string symbol; // "$" is the scene
  int scale = 1;      // 0 for the scene, larger is finer; at most finestScale
  std::string decomposition = "FREE";
  std::string indexation = "FREE";
  std::string definition = "EXPLICIT";

  bool operator==(const MtgClass&) const = default;
};

/// Which classes may follow which: a line of DESCRIPTION, as it is written. Not enforced.
struct MtgRule {
  std::string left;
  std::string right; // one class or more, parted by commas
  std::string edge;  // "<" or "+"
  std::string most;  // how often, a number or "?"

  bool operator==(const MtgRule&) const = default;
};

struct MtgFeature {
  std::string name;
  std::string type;      // "REAL", "INT", "ALPHA", "DD/MM/YY" ...; kept whatever it is
  std::string file = {}; // where its objects are, of a type such as GEOMETRY: "geom1.geom"

  bool operator==(const MtgFeature&) const = default;
};

struct MtgVertex {
  std::string symbol;
  std::optional<LabelIndex> index;
  int scale = 1;
  std::optional<VertexId> complex; // what it is a part of, at a coarser scale; none: of the scene
  std::optional<VertexId> parent;  // at its own scale
  EdgeType edge = EdgeType::successor; // to the parent; without meaning if there is none
  std::vector<std::string> values;     // by feature, as written; empty for none; may end early
  std::string alias = {};              // its name in the file: the value of the feature Alias,
                                       // which is not among `values`
  std::vector<std::vector<std::string>> later = {}; // values at later dates, in order

  bool operator==(const MtgVertex&) const = default;
};

/// A plant described at several scales: a multiscale tree graph.
///
/// Invariants: parent and complex of a vertex come before it; its parent has its scale, its complex
/// a coarser one. The scene is a vertex (of scale 0) only in files that name it. Source: C. Godin,
/// Y. Caraglio, "A multiscale model of plant topological structures", Journal of Theoretical
/// Biology 191, 1998.
struct Mtg {
  std::vector<MtgClass> classes;
  std::vector<MtgRule> rules;
  std::vector<MtgFeature> features;
  std::vector<MtgVertex> vertices; // by VertexId

  bool operator==(const Mtg&) const = default;
};

[[nodiscard]] constexpr std::size_t indexOf(VertexId id) {
  return static_cast<std::size_t>(id);
}

} // namespace espalier
