#include "core/io/formats.h"
#include "core/io/plantgl/bgeom.h"
#include "core/io/plantgl/bmtg.h"
#include "core/io/plantgl/geom.h"
#include "core/io/points/e57.h"
#include "core/io/points/las.h"
#include "core/io/points/laz.h"
#include "core/io/points/part_chooser.h"
#include "core/io/points/pcd.h"
#include "core/io/points/ply.h"
#include "core/io/points/point_glances.h"
#include "core/io/points/ptx.h"
#include "core/io/points/xyz.h"
#include "core/io/qsm/qsm_mat.h"
#include "core/io/qsm/qsm_table.h"
#include "core/io/structures/graphml.h"
#include "core/io/structures/internode_table.h"
#include "core/io/structures/node_list.h"
#include "core/io/structures/opf.h"
#include "core/io/structures/rsml.h"
#include "core/io/structures/skeleton_lines.h"
#include "core/io/structures/surface_files.h"
#include "core/io/structures/swc.h"
#include "core/io/structures/treefile.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_writer.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace espalier {
namespace {

/// Of formats that are read whole, whatever is asked for.
template <auto readWhole>
ImportedPoints readByWhole(std::istream& in, const std::string& file, const ReadOptions& options,
                           const Progress& progress) {
  Imported<RawPoints> whole = readWhole(in, file, progress);
  const std::uint64_t listed = whole.value.positions.size();
  return {{partOf(std::move(whole.value), options), std::move(whole.notes)}, listed};
}

std::vector<Format> makeFormats() {
  std::vector<Format> table;
  table.push_back({.name = "PLY",
                   .description = "PLY points",
                   .extensions = {"ply"},
                   .recognizes = isPly,
                   .readPoints = readPly,
                   .glance = glanceAtPly,
                   .writePoints = writePly});
  table.push_back({.name = "XYZ",
                   .description = "Points as text",
                   .extensions = {"xyz", "asc", "txt", "csv", "pts"},
                   .readPoints = readXyz,
                   .glanceByColumns = glanceAtXyz,
                   .writePoints = writeXyz});
  table.push_back({.name = "LAZ",
                   .description = "Compressed LAS points",
                   .extensions = {"laz"},
                   .recognizes = isLaz,
                   .readPoints = readLaz,
                   .glance = glanceAtLas});
  table.push_back({.name = "LAS",
                   .description = "LAS points",
                   .extensions = {"las"},
                   .recognizes = isLas,
                   .readPoints = readLas,
                   .glance = glanceAtLas});
  table.push_back({.name = "PCD",
                   .description = "PCD points",
                   .extensions = {"pcd"},
                   .recognizes = isPcd,
                   .readPoints = readPcd,
                   .glance = glanceAtPcd});
  table.push_back({.name = "BGEOM",
                   .description = "Binary points of PlantScan3D",
                   .extensions = {"bgeom"},
                   .recognizes = isBgeom,
                   .readPoints = readByWhole<readBgeom>});
  table.push_back({.name = "GEOM",
                   .description = "Text points of PlantGL",
                   .extensions = {"geom"},
                   .readPoints = readByWhole<readGeom>});
  table.push_back({.name = "E57",
                   .description = "E57 scans",
                   .extensions = {"e57"},
                   .recognizes = isE57,
                   .readPoints = readE57,
                   .glance = glanceAtE57});
  table.push_back({.name = "PTX",
                   .description = "PTX scans",
                   .extensions = {"ptx"},
                   .recognizes = isPtx,
                   .readPoints = readPtx,
                   .glance = glanceAtPtx});
  table.push_back({.name = "MTG",
                   .description = "MTG structure",
                   .extensions = {"mtg"},
                   .content = Content::structure,
                   .recognizes = isMtg,
                   .readMtg = readMtg,
                   .writeStructure = writeMtg,
                   .writeMtg = writeMtg,
                   .carried = {.radii = true,
                               .edgeTypes = true,
                               .severalTrees = true,
                               .entities = true,
                               .labels = true,
                               .features = true,
                               .dates = true}});
  table.push_back({.name = "BMTG",
                   .description = "Binary structure of PlantScan3D",
                   .extensions = {"bmtg"},
                   .content = Content::structure,
                   .recognizes = isBmtg,
                   .readMtg = readBmtg});
  table.push_back({.name = "node list",
                   .description = "Node list of PlantScan3D",
                   .extensions = {"txt"},
                   .content = Content::structure,
                   .recognizes = isNodeList,
                   .readStructure = readNodeList,
                   .writeStructure = writeNodeList,
                   .carried = {.radii = true, .edgeTypes = true, .severalTrees = true}});
  table.push_back({.name = "SWC",
                   .description = "SWC structure",
                   .extensions = {"swc"},
                   .content = Content::structure,
                   .recognizes = isSwc,
                   .readStructure = readSwc,
                   .writeStructure = writeSwc,
                   .carried = {.radii = true, .severalTrees = true}});
  table.push_back({.name = "treefile",
                   .description = "Treefile of RayCloudTools",
                   .extensions = {"treefile", "txt"},
                   .content = Content::structure,
                   .recognizes = isTreefile,
                   .readStructure = readTreefile,
                   .writeStructure = writeTreefile,
                   .carried = {.radii = true, .severalTrees = true}});
  table.push_back({.name = "GraphML",
                   .description = "GraphML structure",
                   .extensions = {"graphml"},
                   .content = Content::structure,
                   .recognizes = isGraphml,
                   .readStructure = readGraphml,
                   .writeStructure = writeGraphml,
                   .carried = {.radii = true, .edgeTypes = true, .severalTrees = true}});
  table.push_back({.name = "OPF",
                   .description = "OPF structure",
                   .extensions = {"opf"},
                   .content = Content::structure,
                   .recognizes = isOpf,
                   .readMtg = readOpf,
                   .writeStructure = writeOpf,
                   .writeMtg = writeOpf,
                   .carried = {.radii = true,
                               .edgeTypes = true,
                               .severalTrees = true,
                               .entities = true,
                               .features = true}});
  table.push_back({.name = "RSML",
                   .description = "RSML root systems",
                   .extensions = {"rsml"},
                   .content = Content::structure,
                   .recognizes = isRsml,
                   .readStructure = readRsml,
                   .writeStructure = writeRsml,
                   .carried = {.radii = true, .edgeTypes = true, .severalTrees = true}});
  table.push_back({.name = "OBJ surface",
                   .description = "Surface as OBJ triangles",
                   .extensions = {"obj"},
                   .content = Content::structure,
                   .writeStructure = writeObjSurface,
                   .carried = {.radii = true, .severalTrees = true}});
  table.push_back({.name = "PLY surface",
                   .description = "Surface as PLY triangles",
                   .extensions = {"ply"},
                   .content = Content::structure,
                   .writeStructure = writePlySurface,
                   .carried = {.radii = true, .severalTrees = true}});
  table.push_back({.name = "OBJ lines",
                   .description = "Skeleton as OBJ lines",
                   .extensions = {"lines.obj"},
                   .content = Content::structure,
                   .writeStructure = writeObjLines,
                   .carried = {.severalTrees = true}});
  table.push_back({.name = "PLY lines",
                   .description = "Skeleton as PLY vertices and edges",
                   .extensions = {"lines.ply"},
                   .content = Content::structure,
                   .writeStructure = writePlyLines,
                   .carried = {.radii = true, .edgeTypes = true, .severalTrees = true}});
  table.push_back({.name = "internodes",
                   .description = "Node list with internode lengths and angles",
                   .extensions = {"internodes.csv"},
                   .content = Content::structure,
                   .writeStructure = writeInternodeTable,
                   .carried = {.radii = true, .edgeTypes = true, .severalTrees = true}});
  table.push_back({.name = "QSM table",
                   .description = "Cylinders in TreeQSM's columns",
                   .extensions = {"csv", "txt"},
                   .content = Content::structure,
                   .recognizes = isQsmTable,
                   .readStructure = readQsmTable,
                   .writeStructure = writeQsmTable,
                   .carried = {.radii = true, .edgeTypes = true, .severalTrees = true}});
  table.push_back({.name = "QSM",
                   .description = "Models of TreeQSM",
                   .extensions = {"mat"},
                   .content = Content::structure,
                   .recognizes = isMat,
                   .readStructure = readQsmMat});
  return table;
}

} // namespace

std::span<const Format> formats() {
  static const std::vector<Format> table = makeFormats();
  return table;
}

} // namespace espalier
