#pragma once

#include "core/cloud/point_cloud.h"
#include "core/skeleton/shift_onto_cloud.h"
#include "core/skeleton/skeleton.h"
#include "ui/document/length_unit.h"

#include <Eigen/Core>
#include <QString>

#include <optional>

namespace espalier {

/// How a structure lies to the scan that it is shown with. Neither: it lies on it.
struct ScanFit {
  std::optional<Eigen::Vector3d> shift; // what moves it onto the scan [L]
  std::optional<Misfit> misfit;         // why nothing does
};

/// For a job: time O(N log N) for N points.
[[nodiscard]] ScanFit fitOf(const Skeleton& skeleton, const PointCloud& cloud);

/// The question whether to move a structure.
[[nodiscard]] QString offerToMove(const QString& structure, const Eigen::Vector3d& shift,
                                  LengthUnit unit);

/// In a sentence, why a structure does not lie on a scan, by their names.
[[nodiscard]] QString describe(const Misfit& misfit, const QString& structure, const QString& scan);

} // namespace espalier
