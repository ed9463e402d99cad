#include "core/io/formats.h"

#include "core/base/coordinates.h"
#include "core/base/counted.h"
#include "core/base/error.h"
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

std::string nameOf(const std::filesystem::path& path) {
  return path.filename().string();
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
    throw Error(path.string() + ": is a pipe or device: save it as a file and open that");
  return bytes;
}

/// Whether the reader of a format reads texts in UTF-16, or says what to do with them.
bool knowsUtf16(const Format& format) {
  const auto readers = {isMtg, isGraphml, isOpf, isRsml};
  return std::ranges::find(readers, format.recognizes) != readers.end();
}

const Format& formatOfContent(std::string_view beginning, const std::filesystem::path& path) {
  if (trimmed(beginning).empty()) throw Error(nameOf(path) + ": is empty: copy or export it again");
  for (const Format& format : formats())
    if (format.recognizes != nullptr && format.recognizes(beginning)) return format;
  const Format* format = formatOfName(path, [](const Format&) { return true; });
  if (!format || !knowsUtf16(*format)) requireNoUtf16(beginning, nameOf(path));
  if (format) return *format;
  throw Error(nameOf(path) + ": is of no known kind; can be read: " +
              listOf([](const Format& each) { return each.canRead(); }));
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

/// "1, 2, 3", with as many digits as a person reads.
std::string textOf(const Eigen::Vector3d& place) {
  std::ostringstream text;
  text.precision(9); // millimeters of coordinates in the hundreds of kilometers
  text << place.x() << ", " << place.y() << ", " << place.z();
  return text.str();
}

Error nothingIn(const Eigen::AlignedBox3d& box, const std::filesystem::path& path,
                std::uint64_t listed) {
  const Eigen::AlignedBox3d bounds = glanceAt(path).bounds;
  return Error{nameOf(path) + ": none of its " + counted(listed, "point") +
               " lies in the box from " + textOf(box.min()) + " to " + textOf(box.max()) +
               (bounds.isEmpty()
                    ? ": choose another"
                    : ": they lie from " + textOf(bounds.min()) + " to " + textOf(bounds.max()))};
}

std::string partNote(const ImportedCloud& part, const ReadOptions& options,
                     const std::string& file) {
  const bool isSample =
      options.most > 0 && static_cast<std::uint64_t>(part.value.size()) >= options.most;
  return file + ": " + std::to_string(part.value.size()) + " of " + counted(part.listed, "point") +
         " are read, " +
         (!options.box ? "a sample of all"
          : isSample   ? "a sample of those in the box"
                       : "those in the box");
}

/// Whatever the format: readers that know the line name it before.
void requireInRange(const Skeleton& skeleton, const std::string& file) {
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    if (isInRange(node.position, node.radius)) continue;
    std::ostringstream where;
    where << file << ": a node at " << node.position.transpose() << ", with radius " << node.radius
          << ": ";
    throw outOfRange(where.str());
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
      throw Error("its branches are nested too deeply");
    std::ostringstream text;
    writeMtg(text, mtg.value);
    return {mtgAsWritten(mtg.value), std::move(text).str()};
  } catch (const Error& error) {
    mtg.notes.push_back(file + ": cannot be written as MTG text (" + error.what() +
                        "): a project keeps its skeleton, without the rest of the MTG");
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
  if (const Format* format = formatOfName(path, isWanted)) return *format;
  const bool isAny = !path.has_extension() && isStream(path);
  if (isAny) return *std::ranges::find_if(formats(), isWanted);
  throw Error(nameOf(path) + ": " + (content == Content::points ? "points" : "a structure") +
              " cannot be written with this extension; choose one of " + listOf(isWanted));
}

Imported<PointCloud> readPoints(const std::filesystem::path& path, const Progress& progress) {
  return readPoints(path, ReadOptions(), progress);
}

void requireColumnsFit(const std::filesystem::path& path, const Format& format,
                       const std::vector<PointField>& columns) {
  if (!columns.empty() && format.glanceByColumns == nullptr)
    throw Error(nameOf(path) + ": is " + std::string(format.name) +
                ", which says itself what its columns hold: name columns of text files alone");
}

ImportedCloud readPoints(const std::filesystem::path& path, const ReadOptions& options,
                         const Progress& progress) {
  std::ifstream in = openForReading(path);
  const Format& format = readableFormat(in, path, Content::points);
  requireColumnsFit(path, format, options.columns);
  ImportedPoints raw = format.readPoints(in, nameOf(path), options, progress.part(0, 0.6));
  const std::size_t kept = raw.value.positions.size();
  if (kept == 0 && raw.listed > 0 && options.box) throw nothingIn(*options.box, path, raw.listed);
  ImportedCloud result{
      {PointCloud(std::move(raw.value), progress.part(0.6, 1)), std::move(raw.notes)}, raw.listed};
  const auto finite = static_cast<std::size_t>(result.value.size());
  if (kept == 0) throw Error(nameOf(path) + ": holds no points: export it again");
  if (finite == 0)
    throw Error(nameOf(path) + ": holds " + counted(kept, "point") +
                ", none of them finite: export it again");
  if (std::string note = leftOutNote(result.value, kept, nameOf(path)); !note.empty())
    result.notes.push_back(std::move(note));
  if (result.isPart(options)) result.notes.push_back(partNote(result, options, nameOf(path)));
  for (std::string& note : scanNotes(result.value, nameOf(path)))
    result.notes.push_back(std::move(note));
  return result;
}

Imported<Structure> readStructure(const std::filesystem::path& path) {
  Imported<Structure> structure = readAnyStructure(path);
  if (isWithoutPositions(structure.value)) // says so
    (void)skeletonOf(structure.value.frame->mtg, nameOf(path));
  return structure;
}

Imported<Structure> readAnyStructure(const std::filesystem::path& path) {
  std::ifstream in = openForReading(path);
  const Format& format = readableFormat(in, path, Content::structure);
  const std::string name = nameOf(path);
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
  const Format& format = formatToWrite(path, Content::structure);
  const bool isShapeless = isWithoutPositions(structure);
  if (isShapeless && format.writeMtg == nullptr)
    throw Error(nameOf(path) + ": " + std::string(format.name) +
                " needs positions, and the structure has none: choose MTG or OPF");
  if (isShapeless && format.recognizes != isMtg)
    return writeAtomically(path,
                           [&](std::ostream& out) { format.writeMtg(out, structure.frame->mtg); });
  if (format.recognizes != isMtg) return writeStructure(path, structure.skeleton);
  const std::string text = mtgTextOf(structure, style);
  writeAtomically(path, [&](std::ostream& out) { out << text; });
}

} // namespace espalier
