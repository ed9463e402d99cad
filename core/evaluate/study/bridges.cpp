#include "core/evaluate/study/bridges.h"

#include "core/graph/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace espalier {
namespace {

constexpr double pieceLength = 4;   // in spacings
constexpr double shortestPath = 20; // between points that are far apart, in spacings
constexpr double detour = 3;        // likewise, in distances as scanned

/// How many pieces one passes from one to the other, up to `most`.
class PathsBetween {
public:
  explicit PathsBetween(const PlantPieces& pieces)
      : pieces_(pieces), seenBy_(pieces.adjacent.size(), 0) {}

  int steps(std::uint32_t from, std::uint32_t to, int most) {
    ++search_;
    std::vector<std::uint32_t> front = {from};
    seenBy_[from] = search_;
    for (int steps = 0; steps < most; ++steps) {
      std::vector<std::uint32_t> next;
      for (const std::uint32_t piece : front) {
        if (piece == to) return steps;
        for (const std::uint32_t other : pieces_.adjacent[piece]) {
          if (seenBy_[other] == search_) continue;
          seenBy_[other] = search_;
          next.push_back(other);
        }
      }
      front = std::move(next);
    }
    return most;
  }

private:
  const PlantPieces& pieces_;
  std::vector<std::uint32_t> seenBy_; // by piece: the last search that met it
  std::uint32_t search_ = 0;
};

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// A point of a piece where it is contracted to.
struct Placed {
  std::array<std::int64_t, 3> cell; // a cube of a spacing
  std::uint32_t piece;
  std::uint32_t cube;
  auto operator<=>(const Placed&) const = default; // NOLINT(modernize-use-nullptr): its own 0
};

/// One for each cell and piece that has points there, those of a cell next to each other.
std::vector<Placed> placedPieces(const ThinnedPlant& plant, const PlantPieces& pieces,
                                 const Eigen::Matrix3Xf& places, double spacing) {
  std::vector<Placed> placed;
  for (std::uint32_t cube = 0; cube < plant.points.size(); ++cube) {
    if (plant.isDust[cube]) continue;
    Placed one{.cell = {}, .piece = pieces.ofCube[cube], .cube = cube};
    for (std::size_t axis = 0; axis < 3; ++axis)
      one.cell[axis] = static_cast<std::int64_t>(
          std::floor(static_cast<double>(places(static_cast<Eigen::Index>(axis), cube)) / spacing));
    placed.push_back(one);
  }
  std::ranges::sort(placed);
  const auto isSame = [](const Placed& a, const Placed& b) {
    return a.cell == b.cell && a.piece == b.piece;
  };
  placed.erase(std::unique(placed.begin(), placed.end(), isSame), placed.end());
  return placed;
}

/// Pairs of pieces that come to lie in one cell, each with the least distance between points of
/// them that do, as scanned [spacings].
std::map<Pair, double> meetings(const ThinnedPlant& plant, const std::vector<Placed>& placed,
                                double spacing) {
  std::map<Pair, double> found;
  for (std::size_t begin = 0, end = 0; begin < placed.size(); begin = end) {
    while (end < placed.size() && placed[end].cell == placed[begin].cell)
      ++end;
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = i + 1; j < end; ++j) {
        const Eigen::Vector3f between =
            plant.positions.col(placed[i].cube) - plant.positions.col(placed[j].cube);
        const double apart = static_cast<double>(between.norm()) / spacing;
        double& least = found.try_emplace({placed[i].piece, placed[j].piece}, apart).first->second;
        least = std::min(least, apart);
      }
  }
  return found;
}

} // namespace

Eigen::Index countBridges(const ThinnedPlant& plant, const Eigen::Matrix3Xf& places,
                          double spacing) {
  const PlantPieces pieces = piecesOf(plant, pieceLength * spacing);
  PathsBetween paths(pieces);
  DisjointSets sets(pieces.adjacent.size()); // of bridged pieces that are connected
  std::vector<bool> isBridged(pieces.adjacent.size(), false);
  const std::vector<Placed> placed = placedPieces(plant, pieces, places, spacing);
  for (const auto& [pair, apart] : meetings(plant, placed, spacing)) {
    const int far =
        static_cast<int>(std::ceil(std::max(shortestPath, detour * apart) / pieceLength));
    if (paths.steps(pair.first, pair.second, far + 1) <= far) continue;
    isBridged[pair.first] = isBridged[pair.second] = true;
    sets.join(pair.first, pair.second);
  }
  for (std::uint32_t piece = 0; piece < isBridged.size(); ++piece)
    for (const std::uint32_t other : pieces.adjacent[piece])
      if (isBridged[piece] && isBridged[other]) sets.join(piece, other);
  Eigen::Index count = 0;
  for (std::uint32_t piece = 0; piece < isBridged.size(); ++piece)
    if (isBridged[piece] && sets.find(piece) == piece) ++count;
  return count;
}

} // namespace espalier
