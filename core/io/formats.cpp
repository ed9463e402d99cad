#include "core/io/formats.h"

#include "core/base/coordinates.h"
#include "core/base/open_for_reading.h"
#include "core/base/text.h"
#include "core/base/utf16.h"
#include "core/io/atomic_file.h"
#include "core/io/glance.h"
#include "core/io/scan_notes.h"
#include "core/io/structures/graphml.h"
#include "core/io/structures/opf.h"
#include "core/io/structures/rsml.h"
#include "core/mtg/mtg_reader.h"
#include "core/mtg/mtg_rows.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/mtg/mtg_writer.h"
#include "core/mtg/structure_text.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

namespace espalier {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const char* sentence,
                         std::vector<std::string> values = {}) {
  throw ShownError({sentence, std::move(values), FilePlace{path.string()}});
}

/// The format whose extension the name ends in, of those `wanted`; of "a.lines.obj" that of
/// "lines.obj" rather than of "obj". Null: none.
template <class Wanted>
const Format* formatOfName(const std::filesystem::path& path, const Wanted& wanted) {
  const std::string name = lowerCase(path.filename().string());
  const Format* best = nullptr;
  std::size_t longest = 0;
  for (const Format& format : formats())
    for (const std::string_view extension : format.extensions)
      if (wanted(format) && extension.size() > longest &&
          name.ends_with("." + std::string(extension))) {
        best = &format;
        longest = extension.size();
      }
  return best;
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

std::string beginningOf(std::istream& in, const std::filesystem::path& path) {
  std::string bytes(4096, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  in.clear();
  if (!in.seekg(0))
    throw ShownError({espalier::Shown::tr("is a pipe or device: save it as a file and open that"),
                      {},
                      FilePlace{path.string()}});
  return bytes;
}

/// What the content of a file shows; null: nothing.
const Format* recognized(std::string_view beginning) {
  for (const Format& format : formats())
    if (format.recognizes != nullptr && format.recognizes(beginning)) return &format;
  return nullptr;
}

/// The same of a file; null, too: there is none, or it cannot be read.
const Format* formatIn(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return nullptr;
  std::ifstream in(path, std::ios::binary);
  return in ? recognized(beginningOf(in, path)) : nullptr;
}

/// Whether the reader of a format reads texts in UTF-16, or says what to do with them.
bool knowsUtf16(const Format& format) {
  const auto readers = {isMtg, isGraphml, isOpf, isRsml};
  return std::ranges::find(readers, format.recognizes) != readers.end();
}

const Format& formatOfContent(std::string_view beginning, const std::filesystem::path& path) {
  if (trimmed(beginning).empty()) refuse(path, Shown::tr("is empty: copy or export it again"));
  if (const Format* shown = recognized(beginning)) return *shown;
  const Format* format = formatOfName(path, [](const Format&) { return true; });
  if (!format || !knowsUtf16(*format)) requireNoUtf16(beginning, path.string());
  if (format) return *format;
  if (beginning.starts_with("SQLite format 3")) // as projects are
    refuse(path, Shown::tr("is a project: give the scan or the structure in it, which espalier "
                           "convert writes, or open it in the window"));
  refuse(path, Shown::tr("is of no known kind; can be read: %1"),
         {listOf([](const Format& each) { return each.canRead(); })});
}

/// The format of `in`, which must be of this content and readable.
const Format& readableFormat(std::istream& in, const std::filesystem::path& path, Content content) {
  const Format& format = formatOfContent(beginningOf(in, path), path);
  if (!format.canRead())
    refuse(path,
           Shown::tr("is %1, which cannot be read: open the structure that it was written from"),
           {std::string(format.name)});
  if (format.content != content)
    refuse(path,
           content == Content::points
               ? Shown::tr("holds a structure (%1), not points: choose a scan")
               : Shown::tr("holds points (%1), not a structure: choose an MTG or a node list"),
           {std::string(format.name)});
  return format;
}

/// "1, 2, 3", with as many digits as a person reads.
std::string textOf(const Eigen::Vector3d& place) {
  std::ostringstream text;
  text.precision(9); // millimeters of coordinates in the hundreds of kilometers
  text << place.x() << ", " << place.y() << ", " << place.z();
  return text.str();
}

[[noreturn]] void refuseBox(const Eigen::AlignedBox3d& box, const std::filesystem::path& path,
                            std::uint64_t listed) {
  const PointGlance glance = glanceAt(path);
  const Eigen::AlignedBox3d& bounds = glance.bounds;
  const std::string count = std::to_string(listed);
  if (bounds.isEmpty())
    refuse(path, Shown::tr("none of its %1 points lies in the box from %2 to %3: choose another"),
           {count, textOf(box.min()), textOf(box.max())});
  refuse(path,
         glance.areBoundsOfSample
             ? Shown::tr("none of its %1 points lies in the box from %2 to %3: a sample of them "
                         "lies from %4 to %5")
             : Shown::tr(
                   "none of its %1 points lies in the box from %2 to %3: they lie from %4 to %5"),
         {count, textOf(box.min()), textOf(box.max()), textOf(bounds.min()), textOf(bounds.max())});
}

ShownMessage partNote(const ImportedCloud& part, const ReadOptions& options,
                      const std::string& file) {
  const bool isSample =
      options.most > 0 && static_cast<std::uint64_t>(part.value.size()) >= options.most;
  const char* sentence = Shown::tr("%1 of %2 points are read, those in the box");
  if (!options.box)
    sentence = Shown::tr("%1 of %2 points are read, a sample of all");
  else if (isSample)
    sentence = Shown::tr("%1 of %2 points are read, a sample of those in the box");
  return {
      sentence, {std::to_string(part.value.size()), std::to_string(part.listed)}, FilePlace{file}};
}

/// Whatever the format: readers that know the line name it before.
void requireInRange(const Skeleton& skeleton, const std::string& file) {
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    if (isInRange(node.position, node.radius)) continue;
    std::ostringstream place;
    place << node.position.transpose();
    std::ostringstream radius;
    radius << node.radius;
    throw ShownError({Shown::tr("a node at %1, with radius %2: its place or radius is beyond 1e12, "
                                "as of no plant: correct or remove it"),
                      {place.str(), radius.str()},
                      FilePlace{file}});
  }
}

/// The bytes that a frame was read from, if the format is a text.
std::string textOf(std::istream& in, const Format& format) {
  if (format.recognizes != isMtg) return {};
  in.clear();
  in.seekg(0);
  return readAll(in);
}

/// The frame of an MTG that came without a text: with one of its own, by which projects keep it and
/// whose order of vertices it takes, so that ids are the same when that is read.
MtgFrame frameOf(Imported<Mtg>& mtg, const std::string& file) {
  constexpr std::size_t mostTabs = std::size_t{1} << 26; // a column for each branch off a branch
  try {
    const MtgRows rows = mtgRows(mtg.value);
    if (rows.columns > mostTabs / std::max(rows.rows.size(), std::size_t{1}))
      throw ShownError({Shown::tr("its branches are nested too deeply")});
    std::ostringstream text;
    writeMtg(text, mtg.value);
    return {mtgAsWritten(mtg.value), std::move(text).str()};
  } catch (const Error& error) {
    mtg.notes.push_back({Shown::tr("cannot be written as MTG text (%1): a project keeps its "
                                   "skeleton, without the rest of the MTG"),
                         {error.what()},
                         FilePlace{file}});
    return {std::move(mtg.value), {}};
  }
}

} // namespace

const Format& formatOf(const std::filesystem::path& path) {
  std::ifstream in = openForReading(path);
  return formatOfContent(beginningOf(in, path), path);
}

const Format& formatToWrite(const std::filesystem::path& path, Content content) {
  const auto isWanted = [content](const Format& format) {
    return format.content == content && format.canWrite();
  };
  const Format* present = formatIn(path);
  const auto isPresent = [&](const Format& format) {
    return &format == present && isWanted(format);
  };
  if (const Format* format = formatOfName(path, isPresent)) return *format;
  if (const Format* format = formatOfName(path, isWanted)) return *format;
  const bool isAny = !path.has_extension() && isStream(path);
  if (isAny) return *std::ranges::find_if(formats(), isWanted);
  refuse(path,
         content == Content::points
             ? Shown::tr("points cannot be written with this extension; choose one of %1")
             : Shown::tr("a structure cannot be written with this extension; choose one of %1"),
         {listOf(isWanted)});
}

Imported<PointCloud> readPoints(const std::filesystem::path& path, const Progress& progress) {
  ImportedCloud all = readPoints(path, ReadOptions(), progress);
  return {std::move(all.value), std::move(all.notes)};
}

void requireColumnsFit(const std::filesystem::path& path, const Format& format,
                       const std::vector<PointField>& columns) {
  if (!columns.empty() && format.glanceByColumns == nullptr)
    refuse(path,
           Shown::tr("is %1, which says itself what its columns hold: name columns of text files "
                     "alone"),
           {std::string(format.name)});
}

ImportedCloud readPoints(const std::filesystem::path& path, const ReadOptions& options,
                         const Progress& progress) {
  std::ifstream in = openForReading(path);
  const Format& format = readableFormat(in, path, Content::points);
  requireColumnsFit(path, format, options.columns);
  ImportedPoints raw = format.readPoints(in, path.string(), options, progress.part(0, 0.6));
  const std::size_t kept = raw.value.positions.size();
  if (kept == 0 && raw.listed > 0 && options.box) refuseBox(*options.box, path, raw.listed);
  ImportedCloud result{
      {PointCloud(std::move(raw.value), progress.part(0.6, 1)), std::move(raw.notes)}, raw.listed};
  const auto finite = static_cast<std::size_t>(result.value.size());
  if (kept == 0) refuse(path, Shown::tr("holds no points: export it again"));
  if (finite == 0)
    refuse(path,
           kept == 1 ? Shown::tr("holds 1 point, none of them finite: export it again")
                     : Shown::tr("holds %1 points, none of them finite: export it again"),
           {std::to_string(kept)});
  if (auto note = leftOutNote(result.value, kept, path.string()))
    result.notes.push_back(*std::move(note));
  if (result.isPart(options)) result.notes.push_back(partNote(result, options, path.string()));
  for (ShownMessage& note : scanNotes(result.value, path.string()))
    result.notes.push_back(std::move(note));
  return result;
}

Imported<Structure> readStructure(const std::filesystem::path& path) {
  Imported<Structure> structure = readAnyStructure(path);
  if (isWithoutPositions(structure.value)) // says so
    (void)skeletonOf(structure.value.frame->mtg, path.string());
  return structure;
}

Imported<Structure> readAnyStructure(const std::filesystem::path& path) {
  std::ifstream in = openForReading(path);
  const Format& format = readableFormat(in, path, Content::structure);
  const std::string name = path.string();
  if (format.readStructure) {
    Imported<Skeleton> skeleton = format.readStructure(in, name);
    requireInRange(skeleton.value, name);
    return {{std::move(skeleton.value)}, std::move(skeleton.notes)};
  }
  Imported<Mtg> mtg = format.readMtg(in, name);
  std::string text = textOf(in, format);
  MtgFrame frame =
      text.empty() ? frameOf(mtg, name) : MtgFrame{std::move(mtg.value), std::move(text)};
  return structureOf(std::move(frame), std::move(mtg.notes), name);
}

void writePoints(const std::filesystem::path& path, const PointCloud& cloud,
                 const Progress& progress) {
  writePoints(path, cloud, cloud.positions(), progress);
}

void writePoints(const std::filesystem::path& path, const PointCloud& cloud,
                 const Eigen::Matrix3Xf& positions, const Progress& progress) {
  const Format& format = formatToWrite(path, Content::points);
  writeAtomically(path,
                  [&](std::ostream& out) { format.writePoints(out, cloud, positions, progress); });
}

void writeStructure(const std::filesystem::path& path, const Skeleton& skeleton) {
  const Format& format = formatToWrite(path, Content::structure);
  writeAtomically(path, [&](std::ostream& out) { format.writeStructure(out, skeleton); });
}

void writeStructure(const std::filesystem::path& path, const Structure& structure, MtgStyle style) {
  writeStructure(path, structure, formatToWrite(path, Content::structure), style);
}

void writeStructure(const std::filesystem::path& path, const Structure& structure,
                    const Format& format, MtgStyle style) {
  const bool isShapeless = isWithoutPositions(structure);
  if (isShapeless && format.writeMtg == nullptr)
    refuse(path, Shown::tr("%1 needs positions, and the structure has none: choose MTG or OPF"),
           {std::string(format.name)});
  if (isShapeless && format.recognizes != isMtg)
    return writeAtomically(path,
                           [&](std::ostream& out) { format.writeMtg(out, structure.frame->mtg); });
  if (format.recognizes != isMtg)
    return writeAtomically(
        path, [&](std::ostream& out) { format.writeStructure(out, structure.skeleton); });
  const std::string text = mtgTextOf(structure, style);
  writeAtomically(path, [&](std::ostream& out) { out << text; });
}

} // namespace espalier
