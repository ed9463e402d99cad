#pragma once

#include "core/base/imported.h"
#include "core/skeleton/skeleton.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is GraphML.
[[nodiscard]] bool isGraphml(std::string_view beginning);

/// Skeleton of the first graph of a GraphML file.
///
/// Positions are the data of nodes under keys named x y z, radii under radius or half of diameter;
/// the case of names does not matter, and defaults of keys hold. A directed edge leads from a
/// parent to its child, or all lead the other way; undirected ones, as CATMAID exports, from a
/// child to its parent, if each node has one then. Where some edges are undirected and some are
/// not, the directed ones, synapses, are left out. Data of edges under a key named type, edge_type
/// or edgetype states + or branching, else the edge is a successor; where no edge has any, the
/// child that carries most continues an axis, as `withAssembledAxes` chooses. Other data,
/// hyperedges and graphs within nodes are left out; the notes name the keys.
///
/// @param file  its name, for messages
/// @throws Error naming the line of a node without a position, of an edge between nodes that do not
///         exist, and of a node with two parents or among its own ancestors
/// Time O(size of the file).
/// Specification: U. Brandes et al., "GraphML Progress Report", Graph Drawing 2001;
/// http://graphml.graphdrawing.org.
[[nodiscard]] Imported<Skeleton> readGraphml(std::istream& in, const std::string& file);

/// Writes a directed graph: nodes n1, n2 ... with data x y z radius, edges from the parent to the
/// child with data type, < or +.
/// pre: positions and radii are finite
void writeGraphml(std::ostream& out, const Skeleton& skeleton);

} // namespace espalier
