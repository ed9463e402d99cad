#pragma once

#include "core/base/progress.h"
#include "core/base/spatial_index.h"
#include "core/cloud/point_cloud.h"
#include "core/graph/neighborhood_graph.h"
#include "core/skeleton/edge_index.h"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// An end of a trace.
struct TraceEnd {
  Eigen::Vector3d place; // [L], frame of the file
  bool isFixed = false;  // the trace ends exactly there; else in the middle of the wood there
};

/// What bears a trace: the edge below a node of the plant.
struct TraceBegin {
  NodeId on;           // the upper end of the edge
  double fraction = 1; // of the edge, from its parent on; 1: at the node itself
};

/// A path along the wood, with an entry per node to be made.
struct Trace {
  std::vector<Eigen::Vector3d> places; // from end to end [L], frame of the file; two or more
  /// Of the wood at each place [L]; even between places where it is known, 0 before and behind
  /// them.
  std::vector<double> radii;
  /// Where its first place is on the plant, if it was asked to begin there.
  std::optional<TraceBegin> begin = {};

  [[nodiscard]] double length() const; // along the places [L]
};

struct TraceOptions {
  double step = 0;      // [L] between places, > 0; at least 3 point spacings, and less in bends
  int alternatives = 2; // how many other paths are looked for, >= 0
  /// The plant: what starts at a fixed end on its wood begins where the points leave that wood, and
  /// where they do not, at that end. Null: at that end.
  std::shared_ptr<const EdgeIndex> wood = {};
  bool keepsStart = false; // it begins at that end all the same, without nodes in that wood
};

/// What all traces through one scan share: made once, then asked again and again, by any threads.
///
/// The points are linked to their nearest neighbors, and parts that fall apart by shortest bridges.
/// A path from point to point costs the distance between the places that the two contract to, so it
/// is the length of the axis that counts and not how the path winds over the bark; a leap over a
/// gap costs more the wider it is.
///
/// Places of a trace are spaced evenly, and closer where the line between them would leave the
/// middle of the wood by more than a quarter of its radius or 0.3 spacings, whichever is more.
/// Places of a trace lie within 1.5 spacings of the points beside the wood, or amid thick wood; so
/// none is in a gap. Ends that are fixed are where they are.
class TraceGraph {
public:
  /// @param cloud       not empty
  /// @param contracted  by point, about the origin of the cloud [L]; null: they are contracted here
  /// @throws Cancelled if `progress` asks to stop
  /// Deterministic. Time O(N k log N), and with no contracted points that of contracting.
  explicit TraceGraph(std::shared_ptr<const PointCloud> cloud,
                      std::shared_ptr<const Eigen::Matrix3Xf> contracted = nullptr,
                      const Progress& progress = {});

  [[nodiscard]] const std::shared_ptr<const PointCloud>& cloud() const { return cloud_; }
  [[nodiscard]] double spacing() const { return spacing_; } // between neighboring points [L]

  /// The shortest path from one place to another, then others that clearly differ, best first.
  ///
  /// Other paths are found by making the wood of those before expensive; one that runs along them
  /// for most of its length, or is thrice as long as the first, is no other path.
  /// @return at least one
  /// @throws Cancelled if `progress` asks to stop
  /// Deterministic. Time O(m log m) for m points nearer than the end (A*), per path.
  [[nodiscard]] std::vector<Trace> between(const TraceEnd& from, const TraceEnd& to,
                                           const TraceOptions& options,
                                           const Progress& progress = {}) const;

  /// A path through given places, as by a hand that drew along the points: its ends are as given,
  /// all places between move to the middle of the wood, and those picked on other wood, off the
  /// rest, are left out.
  /// @param places two or more, in order [L]
  [[nodiscard]] Trace through(const std::vector<Eigen::Vector3d>& places, bool startIsFixed,
                              const TraceOptions& options, const Progress& progress = {}) const;

  /// The point to which the path over the points is longest, from the one nearest to a place [L].
  /// Time O(N log N).
  [[nodiscard]] Eigen::Vector3d farthestFrom(const Eigen::Vector3d& place) const;

  /// The same from all points that are at most `about` [L] off some wood; none if that path is
  /// shorter than `least` [L], or no point is so near.
  [[nodiscard]] std::optional<Eigen::Vector3d> farthestFrom(const EdgeIndex& wood, double about,
                                                            double least) const;

private:
  struct PointPath;
  [[nodiscard]] Eigen::Vector3f local(const Eigen::Vector3d& place) const;
  [[nodiscard]] std::uint32_t pointAt(const TraceEnd& end) const;
  [[nodiscard]] PointPath pointPath(std::uint32_t from, std::uint32_t to,
                                    const std::vector<bool>& isExpensive, const Progress& progress,
                                    const std::optional<Eigen::Vector3d>& leap = {}) const;
  [[nodiscard]] double widestLeap(const std::vector<std::uint32_t>& points) const; // [L]
  [[nodiscard]] std::vector<std::uint32_t> woodAlong(const std::vector<std::uint32_t>& points,
                                                     float reach) const;
  [[nodiscard]] std::vector<Eigen::Vector3d> slabAround(std::uint32_t seed,
                                                        const Eigen::Vector3d& place,
                                                        const Eigen::Vector3d& axis,
                                                        double step) const;
  /// @param wood  that it has left; null: none
  [[nodiscard]] Trace traceOf(const std::vector<std::uint32_t>& points, const TraceEnd& from,
                              const TraceEnd& to, double step, const EdgeIndex* wood = {}) const;
  [[nodiscard]] Trace traceFromWood(std::vector<std::uint32_t> points, const TraceEnd& from,
                                    const TraceEnd& to, const TraceOptions& options) const;
  [[nodiscard]] Trace spaced(const Trace& fine, double step) const;
  [[nodiscard]] double toPoints(const Eigen::Vector3d& place) const; // [L], to the nearest
  [[nodiscard]] std::optional<Eigen::Vector3d> onPoints(const Eigen::Vector3d& place,
                                                        double radius) const;
  [[nodiscard]] std::optional<Eigen::Vector3d> strayOn(const std::array<Eigen::Vector3d, 2>& edge,
                                                       double radius) const;
  [[nodiscard]] Trace onThePoints(const Trace& trace, const TraceEnd& from,
                                  const TraceEnd& to) const;

  std::shared_ptr<const PointCloud> cloud_;
  double spacing_;
  std::shared_ptr<const Eigen::Matrix3Xf> contracted_;
  NeighborhoodGraph graph_;
  SpatialIndex scanned_; // of the positions of cloud_
  SpatialIndex inWood_;  // of contracted_
};

} // namespace espalier
