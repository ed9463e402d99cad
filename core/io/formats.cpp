#include "core/io/formats.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/atomic_file.h"
#include "core/io/graphml.h"
#include "core/io/internode_table.h"
#include "core/io/las.h"
#include "core/io/node_list.h"
#include "core/io/opf.h"
#include "core/io/pcd.h"
#include "core/io/ply.h"
#include "core/io/rsml.h"
#include "core/io/skeleton_lines.h"
#include "core/io/swc.h"
#include "core/io/treefile.h"
#include "core/io/xyz.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/mtg_writer.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

namespace espalier {
namespace {

bool isE57(std::string_view beginning) {
  return beginning.starts_with("ASTM-E57");
}

std::vector<Format> makeFormats() {
  std::vector<Format> table;
  table.push_back({.name = "PLY",
                   .description = "PLY points",
                   .extensions = {"ply"},
                   .recognizes = isPly,
                   .readPoints = readPly,
                   .writePoints = writePly});
  table.push_back({.name = "XYZ",
                   .description = "Points as text",
                   .extensions = {"xyz", "asc", "txt", "csv", "pts"},
                   .readPoints = readXyz,
                   .writePoints = writeXyz});
  table.push_back({.name = "LAZ",
                   .description = "Compressed LAS points",
                   .extensions = {"laz"},
                   .recognizes = isLaz,
                   .advice = "unpack it to LAS first, as by 'laszip -i a.laz -o a.las' or "
                             "'pdal translate a.laz a.las'"});
  table.push_back({.name = "LAS",
                   .description = "LAS points",
                   .extensions = {"las"},
                   .recognizes = isLas,
                   .readPoints = readLas});
  table.push_back({.name = "PCD",
                   .description = "PCD points",
                   .extensions = {"pcd"},
                   .recognizes = isPcd,
                   .readPoints = readPcd});
  table.push_back({.name = "E57",
                   .description = "E57 scans",
                   .extensions = {"e57"},
                   .recognizes = isE57,
                   .advice = "convert it to PLY first, as with CloudCompare"});
  table.push_back({.name = "MTG",
                   .description = "MTG structure",
                   .extensions = {"mtg"},
                   .content = Content::structure,
                   .recognizes = isMtg,
                   .readMtg = readMtg,
                   .writeStructure = writeMtg,
                   .carried = {.radii = true, .edgeTypes = true, .severalTrees = true}});
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
  table.push_back({.name = "OBJ lines",
                   .description = "Skeleton as OBJ lines",
                   .extensions = {"obj"},
                   .content = Content::structure,
                   .writeStructure = writeObjLines,
                   .carried = {.severalTrees = true},
                   .advice = "open the structure that it was written from"});
  table.push_back({.name = "PLY lines",
                   .description = "Skeleton as PLY vertices and edges",
                   .extensions = {"ply"},
                   .content = Content::structure,
                   .writeStructure = writePlyLines,
                   .carried = {.radii = true, .edgeTypes = true, .severalTrees = true},
                   .advice = "open the structure that it was written from"});
  table.push_back({.name = "internodes",
                   .description = "Node list with internode lengths and angles",
                   .extensions = {"csv"},
                   .content = Content::structure,
                   .writeStructure = writeInternodeTable,
                   .carried = {.radii = true, .edgeTypes = true, .severalTrees = true},
                   .advice = "open the structure that it was written from"});
  return table;
}

std::string nameOf(const std::filesystem::path& path) {
  return path.filename().string();
}

std::string extensionOf(const std::filesystem::path& path) {
  const std::string extension = lowerCase(path.extension().string());
  return extension.empty() ? extension : extension.substr(1);
}

/// "PLY (.ply), XYZ (.xyz .asc .txt .csv .pts), ..." of the formats that are `wanted`.
template <class Wanted> std::string listOf(const Wanted& wanted) {
  std::string list;
  for (const Format& format : formats()) {
    if (!wanted(format)) continue;
    list += (list.empty() ? "" : ", ") + std::string(format.name) + " (";
    for (const std::string_view extension : format.extensions)
      list += (list.ends_with('(') ? "." : " .") + std::string(extension);
    list += ')';
  }
  return list;
}

std::ifstream openForReading(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto fail = [&](const std::string& what) { throw Error(path.string() + ": " + what); };
  if (std::filesystem::is_directory(path, ignored)) fail("is a folder, choose a file in it");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in)
    fail("cannot be read: " + std::generic_category().message(errno != 0 ? errno : EIO) +
         "; check its name and your rights to it");
  return in;
}

std::string beginningOf(std::istream& in, const std::filesystem::path& path) {
  std::string bytes(4096, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  in.clear();
  if (!in.seekg(0))
    throw Error(path.string() + ": is a pipe or device: save it as a file and open that");
  return bytes;
}

const Format& formatOfContent(std::string_view beginning, const std::filesystem::path& path) {
  if (trimmed(beginning).empty()) throw Error(nameOf(path) + ": is empty: copy or export it again");
  for (const Format& format : formats())
    if (format.recognizes != nullptr && format.recognizes(beginning)) return format;
  const std::string extension = extensionOf(path);
  for (const Format& format : formats())
    if (std::ranges::count(format.extensions, extension) > 0) return format;
  throw Error(nameOf(path) + ": is of no known kind; can be read: " +
              listOf([](const Format& format) { return format.canRead(); }));
}

/// The format of `in`, which must be of this content and readable.
const Format& readableFormat(std::istream& in, const std::filesystem::path& path, Content content) {
  const Format& format = formatOfContent(beginningOf(in, path), path);
  if (!format.canRead())
    throw Error(nameOf(path) + ": is " + std::string(format.name) +
                ", which cannot be read: " + std::string(format.advice));
  if (format.content != content)
    throw Error(nameOf(path) + ": holds " +
                (content == Content::points ? "a structure" : "points") + " (" +
                std::string(format.name) + "), not " +
                (content == Content::points ? "points: choose a scan"
                                            : "a structure: choose an MTG or a node list"));
  return format;
}

/// The bytes that a frame was read from, if the format is a text.
std::string textOf(std::istream& in, const Format& format) {
  if (format.recognizes != isMtg) return {};
  in.clear();
  in.seekg(0);
  return readAll(in);
}

} // namespace

std::span<const Format> formats() {
  static const std::vector<Format> table = makeFormats();
  return table;
}

const Format& formatOf(const std::filesystem::path& path) {
  std::ifstream in = openForReading(path);
  return formatOfContent(beginningOf(in, path), path);
}

const Format& formatToWrite(const std::filesystem::path& path, Content content) {
  const auto isWanted = [content](const Format& format) {
    return format.content == content && format.canWrite();
  };
  const std::string extension = extensionOf(path);
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  const bool isAny = extension.empty() && (std::filesystem::is_character_file(status) ||
                                           std::filesystem::is_fifo(status));
  for (const Format& format : formats())
    if (isWanted(format) && (isAny || std::ranges::count(format.extensions, extension) > 0))
      return format;
  throw Error(nameOf(path) + ": " + (content == Content::points ? "points" : "a structure") +
              " cannot be written with this extension; choose one of " + listOf(isWanted));
}

Imported<PointCloud> readPoints(const std::filesystem::path& path, const Progress& progress) {
  std::ifstream in = openForReading(path);
  const Format& format = readableFormat(in, path, Content::points);
  Imported<RawPoints> raw = format.readPoints(in, nameOf(path), progress.part(0, 0.6));
  const std::size_t listed = raw.value.positions.size();
  Imported<PointCloud> result{PointCloud(std::move(raw.value), progress.part(0.6, 1)),
                              std::move(raw.notes)};
  const auto kept = static_cast<std::size_t>(result.value.size());
  if (listed == 0) throw Error(nameOf(path) + ": holds no points: export it again");
  if (kept == 0)
    throw Error(nameOf(path) + ": none of its " + std::to_string(listed) +
                " points is finite: export it again");
  if (kept < listed)
    result.notes.push_back(nameOf(path) + ": " + std::to_string(listed - kept) + " of " +
                           std::to_string(listed) +
                           " points are not finite, or beyond any plant, and are left out");
  return result;
}

Imported<Structure> readStructure(const std::filesystem::path& path) {
  std::ifstream in = openForReading(path);
  const Format& format = readableFormat(in, path, Content::structure);
  const std::string name = nameOf(path);
  if (format.readStructure) {
    Imported<Skeleton> skeleton = format.readStructure(in, name);
    return {{std::move(skeleton.value)}, std::move(skeleton.notes)};
  }
  Imported<Mtg> mtg = format.readMtg(in, name);
  Imported<Skeleton> skeleton = skeletonOf(mtg.value, name);
  mtg.notes.insert(mtg.notes.end(), skeleton.notes.begin(), skeleton.notes.end());
  auto frame = std::make_shared<const MtgFrame>(MtgFrame{std::move(mtg.value), textOf(in, format)});
  return {{std::move(skeleton.value), std::move(frame)}, std::move(mtg.notes)};
}

void writePoints(const std::filesystem::path& path, const PointCloud& cloud) {
  writePoints(path, cloud, cloud.positions());
}

void writePoints(const std::filesystem::path& path, const PointCloud& cloud,
                 const Eigen::Matrix3Xf& positions) {
  const Format& format = formatToWrite(path, Content::points);
  writeAtomically(path, [&](std::ostream& out) { format.writePoints(out, cloud, positions); });
}

void writeStructure(const std::filesystem::path& path, const Skeleton& skeleton) {
  const Format& format = formatToWrite(path, Content::structure);
  writeAtomically(path, [&](std::ostream& out) { format.writeStructure(out, skeleton); });
}

} // namespace espalier
