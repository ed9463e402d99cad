#pragma once

#include "core/base/imported.h"
#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/io/bytes/byte_source.h"
#include "core/io/points/point_glance.h"
#include "core/io/points/read_options.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "core/mtg/structure.h"

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// What a file holds.
enum class Content : std::uint8_t { points, structure };

/// What a structure format keeps of a skeleton, beside positions and the parent of each node.
struct Carried {
  bool radii = false;
  bool edgeTypes = false;    // which child continues an axis
  bool severalTrees = false; // in one file
  bool entities = false;     // of an MTG: classes, and coarser scales
  bool labels = false;       // their indices and aliases
  bool features = false;     // their values
  bool dates = false;        // their values at later dates

  bool operator==(const Carried&) const = default;
};

/// A file format, and what can be done with it.
struct Format {
  std::string_view name;                    // "PLY"
  std::string_view description;             // for a file dialog: "PLY points"
  std::vector<std::string_view> extensions; // without the point, small letters, the usual one first
  Content content = Content::points;
  bool (*recognizes)(std::string_view beginning) = nullptr; // by content; none: by extension only

  // Those that apply; none for a format that is recognized only to say what to do instead.
  ImportedPoints (*readPoints)(std::istream&, const std::string& file, const ReadOptions&,
                               const Progress&) = nullptr;
  PointGlance (*glance)(ByteSource&, const std::string& file) = nullptr; // none: by reading it
  // Of a format that does not say itself what its columns hold; none there: found out.
  PointGlance (*glanceByColumns)(ByteSource&, const std::string& file,
                                 const std::vector<PointField>& columns) = nullptr;
  Imported<Mtg> (*readMtg)(std::istream&, const std::string& file) = nullptr;
  Imported<Skeleton> (*readStructure)(std::istream&, const std::string& file) = nullptr;
  void (*writePoints)(std::ostream&, const PointCloud&, const Eigen::Matrix3Xf& positions,
                      const Progress&) = nullptr;
  void (*writeStructure)(std::ostream&, const Skeleton&) = nullptr;
  void (*writeMtg)(std::ostream&, const Mtg&) = nullptr; // of a plant without positions
  Carried carried = {};                                  // by what writeStructure writes

  [[nodiscard]] bool canRead() const { return readPoints || readMtg || readStructure; }
  [[nodiscard]] bool canWrite() const {
    return writePoints != nullptr || writeStructure != nullptr;
  }
};

/// All formats. File dialogs and the command line are made from this table.
[[nodiscard]] std::span<const Format> formats();

/// The format of a file: what its content shows, else what its extension says.
/// @throws Error if the file cannot be read, or is of no format known; the message lists those that
/// are
[[nodiscard]] const Format& formatOf(const std::filesystem::path& path);

/// The format to write a file of this name in, known by its extension; of several that share it, as
/// .txt, that of the file which is there, else the first. A device or pipe without extension, as
/// /dev/stdout, gets the first format there is for this content.
/// @throws Error if there is none for this content; the message lists those there are
[[nodiscard]] const Format& formatToWrite(const std::filesystem::path& path, Content content);

/// Points of any format; the notes say what was left out.
/// @throws Error    which file, where in it, what is wrong: also if the file holds a structure, or
/// no
///                  finite point
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] Imported<PointCloud> readPoints(const std::filesystem::path& path,
                                              const Progress& progress = {});

/// Points of a file, and of how many they are.
struct ImportedCloud : Imported<PointCloud> {
  std::uint64_t listed = 0; // in the file

  [[nodiscard]] bool isPart(const ReadOptions& options) const {
    return options.isPart() && static_cast<std::uint64_t>(value.size()) < listed;
  }
};

/// @throws Error if columns are named of a file of a format that says itself what they hold
void requireColumnsFit(const std::filesystem::path& path, const Format& format,
                       const std::vector<PointField>& columns);

/// The points of a file that are asked for; a note says how many of how many they are. Memory
/// follows what is kept, but of compressed PCD and of scenes of PlantGL, which are read whole.
/// @throws Error as above; also if no point lies in the box, or if columns are named of a format
///               that names its own
[[nodiscard]] ImportedCloud readPoints(const std::filesystem::path& path,
                                       const ReadOptions& options, const Progress& progress = {});

/// A skeleton of any structure format, with the MTG that it is a view of if it came from one.
/// @throws Error as readPoints; also if the file holds points
[[nodiscard]] Imported<Structure> readStructure(const std::filesystem::path& path);

/// The same of a structure that may be a plant without its shape (isWithoutPositions), reported by
/// a note: for what needs no positions.
[[nodiscard]] Imported<Structure> readAnyStructure(const std::filesystem::path& path);

/// Writes points in the format of the extension, in the order of the file they came from. The file
/// is complete or as it was before.
/// @throws Error     why it cannot be written
/// @throws Cancelled if `progress` asks to stop
void writePoints(const std::filesystem::path& path, const PointCloud& cloud,
                 const Progress& progress = {});

/// The same with other positions for the points of the cloud, as contraction yields.
/// @param positions  3 x cloud.size() about cloud.origin() [L]
void writePoints(const std::filesystem::path& path, const PointCloud& cloud,
                 const Eigen::Matrix3Xf& positions, const Progress& progress = {});

/// Writes a skeleton in the format of the extension. The file is complete or as it was before.
/// @throws Error why it cannot be written
void writeStructure(const std::filesystem::path& path, const Skeleton& skeleton);

/// The same of a skeleton that came from an MTG: written as MTG, edits go back into it, and its
/// text stays as it was where nothing was edited (see withEdits, mtgTextWith). A plant without its
/// shape is written by what has a place for it.
/// @param style  of an MTG of a structure without scales of its own (hasScales)
/// @throws Error also if the structure has no positions, and the format needs them
void writeStructure(const std::filesystem::path& path, const Structure& structure,
                    MtgStyle style = MtgStyle::plantNode);

/// The same in a format that was chosen. pre: it is one that structures are written in
void writeStructure(const std::filesystem::path& path, const Structure& structure,
                    const Format& format, MtgStyle style = MtgStyle::plantNode);

} // namespace espalier
