#pragma once

#include "core/io/bytes/byte_source.h"
#include "core/io/points/laz_layout.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace espalier {

/// A cell of an octree, whose points are a chunk of their own.
struct CopcNode {
  unsigned level = 0;       // 0: the coarsest, of one cell
  Eigen::AlignedBox3d cube; // that its points lie in [L]
};

/// The nodes of the octree of a COPC file, one for each chunk; none if the file is another LAZ.
///
/// Points of coarser levels are spread over the whole scan; finer ones add to them.
///
/// @param layout  of the file
/// @param file    its name, for messages
/// @throws Error if the octree does not fit the chunks
/// Source: the specification of COPC 1.0, copc.io, 2021.
[[nodiscard]] std::vector<CopcNode> copcNodesOf(ByteSource& source, const LasHeader& header,
                                                const LazLayout& layout, const std::string& file);

} // namespace espalier
