#include "core/clean/ground.h"

#include "core/base/parallel.h"
#include "core/base/quantile.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace espalier {
namespace {

constexpr double mostCells = 4e6;
constexpr double unsupported = std::numeric_limits<double>::infinity();

/// The cells of the cloth and the points above each, the lowest first.
struct GroundCells {
  Eigen::Vector2d corner; // of the first cell [L]
  double cell;
  Eigen::Index columns, rows;
  std::vector<std::size_t> begin; // by cell, and one more
  std::vector<float> heights;

  GroundCells(const Eigen::Matrix3Xf& points, double wanted, const Progress& progress) {
    corner = points.topRows<2>().rowwise().minCoeff().cast<double>();
    const Eigen::Vector2d size = points.topRows<2>().rowwise().maxCoeff().cast<double>() - corner;
    cell = std::max({wanted, std::sqrt(size.prod() / mostCells), size.maxCoeff() / mostCells * 4,
                     std::numeric_limits<double>::min()});
    columns = static_cast<Eigen::Index>(size.x() / cell) + 1;
    rows = static_cast<Eigen::Index>(size.y() / cell) + 1;
    fill(points, progress);
  }

  [[nodiscard]] std::span<const float> at(Eigen::Index column, Eigen::Index row) const {
    if (column < 0 || row < 0 || column >= columns || row >= rows) return {};
    const auto place = static_cast<std::size_t>(column + columns * row);
    return {heights.data() + begin[place], heights.data() + begin[place + 1]};
  }

private:
  void fill(const Eigen::Matrix3Xf& points, const Progress& progress) {
    struct Placed {
      std::uint32_t cell;
      float height;
      std::uint32_t point;
    };
    std::vector<Placed> placed(static_cast<std::size_t>(points.cols()));
    parallelFor(
        points.cols(),
        [&](Eigen::Index i) {
          const Eigen::Vector2d at = (points.col(i).head<2>().cast<double>() - corner) / cell;
          const auto column = std::min(static_cast<Eigen::Index>(at.x()), columns - 1);
          const auto row = std::min(static_cast<Eigen::Index>(at.y()), rows - 1);
          placed[static_cast<std::size_t>(i)] = {static_cast<std::uint32_t>(column + columns * row),
                                                 points(2, i), static_cast<std::uint32_t>(i)};
        },
        progress.part(0, 0.3), 4096);
    parallelSort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
      if (a.cell != b.cell) return a.cell < b.cell;
      return a.height != b.height ? a.height < b.height : a.point < b.point;
    });
    progress.update(0.9);
    begin.assign(static_cast<std::size_t>(columns * rows) + 1, 0);
    heights.reserve(placed.size());
    for (const Placed& one : placed) {
      ++begin[one.cell + 1];
      heights.push_back(one.height);
    }
    for (std::size_t i = 1; i < begin.size(); ++i)
      begin[i] += begin[i - 1];
  }
};

/// How many others bear out a height: two, but more where points are so dense that as many strays
/// are near each other by chance.
Eigen::Index fewestOthers(const GroundCells& cells) {
  constexpr double share = 9.0 / 100; // of the points of a cell: it is looked at with those beside
  std::vector<double> counts;
  for (std::size_t i = 0; i + 1 < cells.begin.size(); ++i)
    if (cells.begin[i + 1] > cells.begin[i])
      counts.push_back(static_cast<double>(cells.begin[i + 1] - cells.begin[i]));
  return std::max<Eigen::Index>(2,
                                std::lround(share * quantile(std::move(counts), 0.5).value_or(0)));
}

/// Whether at least so many other points around a cell are about as high.
bool isBorneOut(const GroundCells& cells, Eigen::Index column, Eigen::Index row, float height,
                Eigen::Index others) {
  const auto band = static_cast<float>(1.5 * cells.cell);
  Eigen::Index found = -1; // itself
  for (Eigen::Index j = row - 1; j <= row + 1; ++j)
    for (Eigen::Index i = column - 1; i <= column + 1; ++i) {
      const std::span<const float> near = cells.at(i, j);
      found += std::ranges::upper_bound(near, height + band) -
               std::ranges::lower_bound(near, height - band);
    }
  return found >= others;
}

/// The lowest height of each cell that others bear out; unsupported where there is none.
Eigen::MatrixXd lowestOf(const GroundCells& cells, const Progress& progress) {
  Eigen::MatrixXd lowest = Eigen::MatrixXd::Constant(cells.columns, cells.rows, unsupported);
  const Eigen::Index others = fewestOthers(cells);
  parallelFor(
      cells.rows,
      [&](Eigen::Index row) {
        for (Eigen::Index column = 0; column < cells.columns; ++column)
          for (const float height : cells.at(column, row))
            if (isBorneOut(cells, column, row, height, others)) {
              lowest(column, row) = static_cast<double>(height);
              break;
            }
      },
      progress, 8);
  return lowest;
}

/// The plane a + b i + c j with the least sum of distances to the lowest heights.
Eigen::Vector3d trendOf(const Eigen::MatrixXd& lowest, double cell, const Progress& progress) {
  std::vector<Eigen::Vector3d> places;
  const Eigen::Index step = std::max<Eigen::Index>(1, std::max(lowest.rows(), lowest.cols()) / 400);
  for (Eigen::Index j = 0; j < lowest.cols(); j += step)
    for (Eigen::Index i = 0; i < lowest.rows(); i += step)
      if (lowest(i, j) != unsupported)
        places.emplace_back(static_cast<double>(i), static_cast<double>(j), lowest(i, j));
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  if (places.size() < 3) {
    if (!places.empty()) plane[0] = places.front().z();
    return plane;
  }
  for (int iteration = 0; iteration < 40; ++iteration) {
    progress.check();
    Eigen::Matrix3d sums = Eigen::Matrix3d::Identity() * 1e-9;
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& place : places) {
      const Eigen::Vector3d row(1, place.x(), place.y());
      const double away = std::abs(place.z() - row.dot(plane));
      const double weight = iteration == 0 ? 1 : 1 / std::max(away, cell / 10);
      sums += weight * row * row.transpose();
      right += weight * place.z() * row;
    }
    plane = sums.ldlt().solve(right);
  }
  return plane;
}

/// Fills what holds nothing with the height of the nearest that does.
void fillFromNearest(Eigen::MatrixXd& heights) {
  std::vector<std::pair<Eigen::Index, Eigen::Index>> queue;
  for (Eigen::Index j = 0; j < heights.cols(); ++j)
    for (Eigen::Index i = 0; i < heights.rows(); ++i)
      if (heights(i, j) != unsupported) queue.emplace_back(i, j);
  constexpr std::array<std::pair<int, int>, 4> beside{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const auto [i, j] = queue[next];
    for (const auto& [di, dj] : beside) {
      const Eigen::Index x = i + di;
      const Eigen::Index y = j + dj;
      if (x < 0 || y < 0 || x >= heights.rows() || y >= heights.cols()) continue;
      if (heights(x, y) != unsupported) continue;
      heights(x, y) = heights(i, j);
      queue.emplace_back(x, y);
    }
  }
}

/// A cloth above heights that hold it: the scan turned over.
class Cloth {
public:
  Cloth(const Eigen::MatrixXd& held, double cell, const GroundOptions& options)
      : held_(held), cell_(cell), options_(options), free_(1 - std::pow(0.7, options.rigidness)),
        both_(0.5 * (1 - std::pow(0.4, options.rigidness))) {
    height_ = Eigen::MatrixXd::Constant(held.rows(), held.cols(), held.maxCoeff() + cell);
    before_ = height_;
    isHeld_.setZero(held.rows(), held.cols());
  }

  void fall(const Progress& progress) {
    constexpr double atRest = 0.005; // of a cell
    for (int i = 0; i < options_.iterations; ++i) {
      progress.update(static_cast<double>(i) / options_.iterations);
      drop();
      pull();
      if (hold() < atRest * cell_ && i > 20) break;
    }
    if (options_.followSlopes) settle();
  }

  [[nodiscard]] const Eigen::MatrixXd& heights() const { return height_; }

private:
  /// Verlet's step of free fall, damped.
  void drop() {
    constexpr double gravity = 0.1; // cells per step^2
    constexpr double damping = 0.01;
    for (Eigen::Index j = 0; j < height_.cols(); ++j)
      for (Eigen::Index i = 0; i < height_.rows(); ++i) {
        if (isHeld_(i, j)) continue;
        const double now = height_(i, j);
        height_(i, j) += (1 - damping) * (now - before_(i, j)) - gravity * cell_;
        before_(i, j) = now;
      }
  }

  void pull() {
    constexpr std::array<std::pair<int, int>, 8> springs{
        {{1, 0}, {0, 1}, {1, 1}, {-1, 1}, {2, 0}, {0, 2}, {2, 2}, {-2, 2}}};
    for (Eigen::Index j = 0; j < height_.cols(); ++j)
      for (Eigen::Index i = 0; i < height_.rows(); ++i)
        for (const auto& [di, dj] : springs) {
          const Eigen::Index x = i + di;
          const Eigen::Index y = j + dj;
          if (x < 0 || x >= height_.rows() || y >= height_.cols()) continue;
          const double difference = height_(x, y) - height_(i, j);
          if (!isHeld_(i, j)) height_(i, j) += (isHeld_(x, y) ? free_ : both_) * difference;
          if (!isHeld_(x, y)) height_(x, y) -= (isHeld_(i, j) ? free_ : both_) * difference;
        }
  }

  /// @return how far a particle moved at most
  double hold() {
    double most = 0;
    for (Eigen::Index j = 0; j < height_.cols(); ++j)
      for (Eigen::Index i = 0; i < height_.rows(); ++i) {
        if (isHeld_(i, j)) continue;
        if (height_(i, j) <= held_(i, j)) {
          height_(i, j) = held_(i, j);
          isHeld_(i, j) = 1;
        }
        most = std::max(most, std::abs(height_(i, j) - before_(i, j)));
      }
    return most;
  }

  /// On slopes particles hang above points that neighbors of theirs lie on: they come down to them.
  void settle() {
    const double near = 0.6 * cell_;
    std::vector<std::pair<Eigen::Index, Eigen::Index>> queue;
    for (Eigen::Index j = 0; j < height_.cols(); ++j)
      for (Eigen::Index i = 0; i < height_.rows(); ++i)
        if (isHeld_(i, j)) queue.emplace_back(i, j);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const auto [i, j] = queue[next];
      for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di) {
          const Eigen::Index x = i + di;
          const Eigen::Index y = j + dj;
          if (x < 0 || y < 0 || x >= height_.rows() || y >= height_.cols()) continue;
          if (isHeld_(x, y) || std::abs(held_(x, y) - held_(i, j)) > near ||
              height_(x, y) - held_(x, y) > near)
            continue;
          height_(x, y) = held_(x, y);
          isHeld_(x, y) = 1;
          queue.emplace_back(x, y);
        }
    }
  }

  const Eigen::MatrixXd& held_;
  double cell_;
  GroundOptions options_;
  double free_; // share of a difference that a particle gives way by, if the other is held
  double both_; // and if neither is
  Eigen::MatrixXd height_, before_;
  Eigen::Matrix<char, Eigen::Dynamic, Eigen::Dynamic> isHeld_;
};

} // namespace

GroundOptions resolved(GroundOptions options, const PlantScale& scale) {
  options.cell = lengthAt(options.cell, scale);
  options.tolerance = lengthAt(options.tolerance, scale);
  options.noise = lengthAt(options.noise, scale);
  return options;
}

double GroundSurface::at(double x, double y) const {
  const auto along = [this](double value, double from, Eigen::Index count) {
    return std::clamp((value - from) / cell, 0.0, static_cast<double>(count - 1));
  };
  const double i = along(x, corner.x(), heights.rows());
  const double j = along(y, corner.y(), heights.cols());
  const auto i0 =
      std::min(static_cast<Eigen::Index>(i), std::max<Eigen::Index>(heights.rows() - 2, 0));
  const auto j0 =
      std::min(static_cast<Eigen::Index>(j), std::max<Eigen::Index>(heights.cols() - 2, 0));
  const Eigen::Index i1 = std::min(i0 + 1, heights.rows() - 1);
  const Eigen::Index j1 = std::min(j0 + 1, heights.cols() - 1);
  const double u = i - static_cast<double>(i0);
  const double v = j - static_cast<double>(j0);
  return (1 - v) * ((1 - u) * heights(i0, j0) + u * heights(i1, j0)) +
         v * ((1 - u) * heights(i0, j1) + u * heights(i1, j1));
}

GroundSurface groundBelow(const Eigen::Matrix3Xf& points, const GroundOptions& options,
                          const Progress& progress) {
  GroundSurface ground;
  if (points.cols() == 0) return ground;
  const auto lowestIn = [](const GroundCells& cells, const Progress& part) {
    Eigen::MatrixXd lowest = lowestOf(cells, part);
    if ((lowest.array() == unsupported).all())
      lowest.setConstant(static_cast<double>(*std::ranges::min_element(cells.heights)));
    return lowest;
  };
  const GroundCells rough(points, options.cell, progress.part(0, 0.2));
  const Eigen::Vector3d plane =
      trendOf(lowestIn(rough, progress.part(0.2, 0.25)), rough.cell, progress.part(0.25, 0.3));
  const Eigen::Vector2d rise = plane.tail<2>() / rough.cell;
  Eigen::Matrix3Xf level = points; // the lowest of a cell is not that at its lower side
  level.row(2) -= (rise.transpose() * (points.topRows<2>().cast<double>().colwise() - rough.corner))
                      .cast<float>();
  const GroundCells cells(level, options.cell, progress.part(0.3, 0.5));
  Eigen::MatrixXd lowest = -lowestIn(cells, progress.part(0.5, 0.55)); // turned over
  for (double& height : lowest.reshaped())
    if (height == -unsupported) height = unsupported;
  fillFromNearest(lowest);
  Cloth cloth(lowest, cells.cell, options);
  cloth.fall(progress.part(0.55, 1));
  ground.cell = cells.cell;
  ground.corner = cells.corner.array() + cells.cell / 2; // nodes are in the middle of cells
  ground.heights = -cloth.heights();
  for (Eigen::Index j = 0; j < lowest.cols(); ++j)
    for (Eigen::Index i = 0; i < lowest.rows(); ++i)
      ground.heights(i, j) += rise.dot(
          Eigen::Vector2d(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5) * cells.cell);
  return ground;
}

std::vector<float> heightsAbove(const GroundSurface& ground, const Eigen::Matrix3Xf& points) {
  std::vector<float> heights(static_cast<std::size_t>(points.cols()));
  parallelFor(
      points.cols(),
      [&](Eigen::Index i) {
        const Eigen::Vector3d at = points.col(i).cast<double>();
        heights[static_cast<std::size_t>(i)] =
            static_cast<float>(at.z() - ground.at(at.x(), at.y()));
      },
      {}, 4096);
  return heights;
}

} // namespace espalier
