#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

namespace espalier {

struct ImplicitLaplacianOptions {
  int neighbors = 16;        // candidates for the ring about each point, >= 3
  double contraction = 0.05; // factor on the first weight of contraction, > 0
  double growth = 2;         // of that weight from round to round, >= 1
  int rounds = 2;            // >= 0
};

/// Contracts a cloud by solving for places where its Laplacian is nearly 0, again and again.
///
/// Each point has a ring of neighbors, the first of which Delaunay's triangulation of its tangent
/// plane gives; cotangents of their triangles make the Laplacian L. A round solves, by least
/// squares, W_L L X' = 0 and W_H X' = W_H X; then W_L grows by `growth` up to 2048, and W_H of a
/// point by what the triangles about it have shrunk since the start, so that what is a line already
/// stays. It ends early once these shrink by less than 1 % a round.
/// Holes in the scan do little harm; thin twigs get shorter, more so with every round.
///
/// @param points 3 x N, finite [L]
/// @return 3 x N, the new place of each point [L]
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time about O(N^1.5) per round, memory O(N log N): a few hundred MB for 100 k
/// points.
/// Source: J. Cao, A. Tagliasacchi, M. Olson, H. Zhang, Z. Su, "Point cloud skeletons via Laplacian
/// based contraction", SMI 2010; weights after O. K.-C. Au et al., ACM Trans. Graph. 27(3), 2008.
/// Differs: cotangents are kept between 1/1000 and 1000, so that triangles that have collapsed do
/// no harm; the first weight is 1 / (5 mean extent of the rings) for a cloud whose box has a
/// diagonal of 1.6, as in the authors' program, and so knows no unit. Defaults are gentler than
/// theirs (1, 3, until nothing shrinks): these straighten the twigs of simulated plants.
[[nodiscard]] Eigen::Matrix3Xf
contractedByImplicitLaplacian(const Eigen::Matrix3Xf& points,
                              const ImplicitLaplacianOptions& options,
                              const Progress& progress = {});

} // namespace espalier
