#include "core/evaluate/study/thinned_plant.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <unordered_map>
#include <utility>

namespace espalier {
namespace {

/// The cube that each point is in; cubes are numbered as they are met.
std::vector<std::uint32_t> cubesOf(const Eigen::Matrix3Xf& points, double side,
                                   const Progress& progress) {
  const Eigen::Vector3d corner = points.rowwise().minCoeff().cast<double>();
  std::vector<std::uint32_t> cubes(static_cast<std::size_t>(points.cols()));
  std::unordered_map<std::uint64_t, std::uint32_t> numbers;
  numbers.reserve(cubes.size() / 2);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if (i % (1 << 16) == 0) progress.check();
    std::uint64_t key = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double place = (static_cast<double>(points(axis, i)) - corner[axis]) / side;
      key = key << 21 | (static_cast<std::uint64_t>(place) & 0x1fffff);
    }
    const auto next = static_cast<std::uint32_t>(numbers.size());
    cubes[static_cast<std::size_t>(i)] = numbers.try_emplace(key, next).first->second;
  }
  return cubes;
}

/// The cubes of each connected part.
std::vector<std::vector<std::uint32_t>> partsOf(const ThinnedPlant& plant) {
  std::vector<bool> isMet(plant.points.size(), false);
  std::vector<std::vector<std::uint32_t>> parts;
  for (std::uint32_t first = 0; first < plant.points.size(); ++first) {
    if (isMet[first]) continue;
    isMet[first] = true;
    std::vector<std::uint32_t> part = {first};
    for (std::size_t next = 0; next < part.size(); ++next)
      for (const NeighborhoodGraph::Link& link : plant.graph.links(part[next])) {
        if (isMet[link.to] || !plant.holds(link)) continue;
        isMet[link.to] = true;
        part.push_back(link.to);
      }
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Where the distances of a part begin.
std::uint32_t footOf(const std::vector<std::uint32_t>& part, const Eigen::Matrix3Xf& positions,
                     const std::optional<Eigen::Vector3f>& root) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::uint32_t cube : part)
    mean += positions.col(cube).cast<double>() / static_cast<double>(part.size());
  return *std::ranges::min_element(part, {}, [&](std::uint32_t cube) {
    const Eigen::Vector3d place = positions.col(cube).cast<double>();
    const double rank =
        root ? (place - root->cast<double>()).squaredNorm() : -(place - mean).squaredNorm();
    return std::pair(rank, cube);
  });
}

/// Shortest paths from the feet, along links that hold.
std::vector<float> distancesFrom(const std::vector<std::uint32_t>& feet, const ThinnedPlant& plant,
                                 const Progress& progress) {
  using Item = std::pair<float, std::uint32_t>;
  std::vector<float> distance(plant.points.size(), std::numeric_limits<float>::infinity());
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (const std::uint32_t foot : feet) {
    distance[foot] = 0;
    queue.emplace(0.0F, foot);
  }
  for (std::size_t taken = 0; !queue.empty(); ++taken) {
    if (taken % (1 << 14) == 0) progress.check();
    const auto [at, cube] = queue.top();
    queue.pop();
    if (at > distance[cube]) continue;
    for (const NeighborhoodGraph::Link& link : plant.graph.links(cube)) {
      if (!plant.holds(link) || at + link.length >= distance[link.to]) continue;
      distance[link.to] = at + link.length;
      queue.emplace(distance[link.to], link.to);
    }
  }
  return distance;
}

} // namespace

ThinnedPlant thinnedPlant(const Eigen::Matrix3Xf& points, double spacing,
                          const std::optional<Eigen::Vector3f>& root, const Progress& progress) {
  std::vector<std::uint32_t> cubeOf;
  std::vector<Eigen::Index> first;
  std::vector<Eigen::Index> counts;
  if (points.cols() > 0) cubeOf = cubesOf(points, ThinnedPlant::cubeSide * spacing, progress);
  for (std::size_t i = 0; i < cubeOf.size(); ++i) {
    if (cubeOf[i] == first.size()) {
      first.push_back(static_cast<Eigen::Index>(i));
      counts.push_back(0);
    }
    ++counts[cubeOf[i]];
  }
  Eigen::Matrix3Xf positions = points(Eigen::all, first);
  NeighborhoodGraph graph(positions, ThinnedPlant::linksPerPoint, progress.part(0.1, 0.7));
  ThinnedPlant plant{.cubeOf = std::move(cubeOf),
                     .longest = static_cast<float>(ThinnedPlant::longestLink * spacing),
                     .points = std::move(first),
                     .counts = std::move(counts),
                     .positions = std::move(positions),
                     .graph = std::move(graph),
                     .isDust = {},
                     .distance = {}};
  plant.isDust.assign(plant.points.size(), false);
  std::vector<std::uint32_t> feet;
  for (const std::vector<std::uint32_t>& part : partsOf(plant)) {
    if (part.size() >= ThinnedPlant::dust)
      feet.push_back(footOf(part, plant.positions, root));
    else
      for (const std::uint32_t cube : part)
        plant.isDust[cube] = true;
  }
  plant.distance = distancesFrom(feet, plant, progress.part(0.7, 1));
  return plant;
}

std::vector<std::uint32_t> endsOf(const ThinnedPlant& plant, double shortest) {
  // Cubes from the farthest inwards: what they reach grows together. Where two parts meet, the one
  // that ends nearer to the foot is an end if it is long enough.
  std::vector<std::uint32_t> order;
  for (std::uint32_t cube = 0; cube < plant.points.size(); ++cube)
    if (!plant.isDust[cube]) order.push_back(cube);
  const auto isFarther = [&](std::uint32_t a, std::uint32_t b) {
    return plant.distance[a] != plant.distance[b] ? plant.distance[a] > plant.distance[b] : a < b;
  };
  std::ranges::sort(order, isFarther);
  std::vector<std::uint32_t> within(plant.points.size(), PlantPieces::none); // towards its end
  const auto endOf = [&](std::uint32_t cube) {
    while (within[cube] != cube)
      cube = within[cube] = within[within[cube]];
    return cube;
  };
  const auto length = [&](std::uint32_t end, std::uint32_t at) {
    return static_cast<double>(plant.distance[end] - plant.distance[at]);
  };
  std::vector<std::uint32_t> ends;
  for (const std::uint32_t cube : order) {
    within[cube] = cube;
    for (const NeighborhoodGraph::Link& link : plant.graph.links(cube)) {
      if (!plant.holds(link) || within[link.to] == PlantPieces::none) continue;
      std::uint32_t farther = endOf(link.to);
      std::uint32_t nearer = endOf(cube);
      if (farther == nearer) continue;
      if (isFarther(nearer, farther)) std::swap(nearer, farther);
      if (length(nearer, cube) >= shortest) ends.push_back(nearer);
      within[nearer] = farther;
    }
  }
  for (const std::uint32_t cube : order) // what no other part outlasts
    if (within[cube] == cube && static_cast<double>(plant.distance[cube]) >= shortest)
      ends.push_back(cube);
  std::ranges::sort(ends);
  return ends;
}

PlantPieces piecesOf(const ThinnedPlant& plant, double pieceLength) {
  PlantPieces pieces;
  pieces.ofCube.assign(plant.points.size(), PlantPieces::none);
  const auto stretchOf = [&](std::uint32_t cube) {
    return std::floor(static_cast<double>(plant.distance[cube]) / pieceLength);
  };
  std::uint32_t count = 0;
  std::vector<std::uint32_t> stack;
  for (std::uint32_t first = 0; first < plant.points.size(); ++first) {
    if (plant.isDust[first] || pieces.ofCube[first] != PlantPieces::none) continue;
    stack.push_back(first);
    pieces.ofCube[first] = count;
    while (!stack.empty()) {
      const std::uint32_t cube = stack.back();
      stack.pop_back();
      for (const NeighborhoodGraph::Link& link : plant.graph.links(cube)) {
        if (!plant.holds(link) || pieces.ofCube[link.to] != PlantPieces::none ||
            stretchOf(link.to) != stretchOf(cube))
          continue;
        pieces.ofCube[link.to] = count;
        stack.push_back(link.to);
      }
    }
    ++count;
  }
  pieces.adjacent.resize(count);
  for (std::uint32_t cube = 0; cube < plant.points.size(); ++cube)
    for (const NeighborhoodGraph::Link& link : plant.graph.links(cube))
      if (plant.holds(link) && pieces.ofCube[cube] != pieces.ofCube[link.to])
        pieces.adjacent[pieces.ofCube[cube]].push_back(pieces.ofCube[link.to]);
  for (std::vector<std::uint32_t>& list : pieces.adjacent) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return pieces;
}

} // namespace espalier
