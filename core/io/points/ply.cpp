#include "core/io/points/ply.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/cloud/file_order.h"
#include "core/io/bytes/byte_stream.h"
#include "core/io/bytes/line_stream.h"
#include "core/io/points/ply_header.h"
#include "core/io/points/point_collector.h"
#include "core/io/points/station_comment.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <ostream>
#include <utility>

namespace espalier {
namespace {

/// Fields by property of `element`.
std::vector<PointField> fieldsOf(const PlyElement& element, const std::string& file) {
  std::vector<PointField> fields;
  std::array<bool, PointValues().size()> taken{};
  for (const PlyProperty& property : element.properties) {
    const PointField field = property.countType ? PointField::none : pointFieldNamed(property.name);
    const bool isTaken = std::exchange(taken[indexOf(field)], true);
    fields.push_back(isTaken || field == PointField::packedColor ? PointField::none : field);
  }
  for (const auto& [field, name] : {std::pair{PointField::x, "x"}, std::pair{PointField::y, "y"},
                                    std::pair{PointField::z, "z"}})
    if (!taken[indexOf(field)])
      throw ShownError(
          {Shown::tr("its element 'vertex' has no property '%1': export it with x, y and z"),
           {name},
           FilePlace{file}});
  return fields;
}

/// Whether the colors are of a type in which 1 may stand for full light.
bool hasFractions(const PlyElement& element, const std::vector<PointField>& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (fields[i] == PointField::red) return isFloat(element.properties[i].type);
  return false;
}

[[noreturn]] void failCutShort(const std::string& file, const PlyElement& element,
                               std::uint64_t row) {
  throw ShownError(
      {Shown::tr(
           "ends within %1 %2 of %3: the file is cut short or damaged, copy or export it again"),
       {element.name, std::to_string(row + 1), std::to_string(element.count)},
       FilePlace{file}});
}

/// The binary rows of a PLY file, one after another.
class BinaryRows {
public:
  BinaryRows(ByteStream bytes, std::endian order, const std::string& file)
      : bytes_(std::move(bytes)), order_(order), file_(file) {}

  [[nodiscard]] std::uint64_t left() const { return bytes_.left(); }

  /// Reads row `row`; `fields` may be empty: then the row is passed over.
  void read(const PlyElement& element, std::uint64_t row, const std::vector<PointField>& fields,
            PointValues& values) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.countType) {
        const double length =
            scalarAt(take(element, row, sizeOf(*property.countType)), *property.countType, order_);
        // Compared as double: a damaged length may be negative or beyond any size.
        if (!(length >= 0 && length * static_cast<double>(sizeOf(property.type)) <=
                                 static_cast<double>(bytes_.left())))
          failCutShort(file_, element, row);
        bytes_.skip(static_cast<std::uint64_t>(length) * sizeOf(property.type));
        continue;
      }
      const char* bytes = take(element, row, sizeOf(property.type));
      if (!fields.empty() && fields[i] != PointField::none)
        values[indexOf(fields[i])] = scalarAt(bytes, property.type, order_);
    }
  }

  void skip(const PlyElement& element) {
    PointValues unused{};
    if (element.hasLists()) {
      for (std::uint64_t row = 0; row < element.count; ++row)
        read(element, row, {}, unused);
    } else if (element.leastSize() > 0) {
      checkPromise(FilePlace{file_}, element.count, element.leastSize(), bytes_.left());
      bytes_.skip(element.count * element.leastSize());
    }
  }

private:
  const char* take(const PlyElement& element, std::uint64_t row, std::size_t size) {
    const char* bytes = size > bytes_.left() ? nullptr : bytes_.take(size);
    if (bytes == nullptr) failCutShort(file_, element, row);
    return bytes;
  }

  ByteStream bytes_;
  std::endian order_;
  const std::string& file_;
};

/// The text rows of a PLY file, a line each.
class AsciiRows {
public:
  AsciiRows(LineStream lines, std::size_t linesBefore, const std::string& file)
      : lines_(std::move(lines)), linesBefore_(linesBefore), file_(file) {}

  [[nodiscard]] std::uint64_t left() const { return lines_.size() - lines_.offset(); }

  void read(const PlyElement& element, std::uint64_t row, const std::vector<PointField>& fields,
            PointValues& values) {
    std::string_view rest = nextLine(element, row);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const double number = nextNumber(rest, element, i);
      if (element.properties[i].countType) {
        for (double item = 0; item < number && !nextWord(rest).empty();)
          ++item;
      } else if (fields[i] != PointField::none) {
        values[indexOf(fields[i])] = number;
      }
    }
  }

  void skip(const PlyElement& element) {
    for (std::uint64_t row = 0; row < element.count; ++row)
      nextLine(element, row);
  }

private:
  std::string_view nextLine(const PlyElement& element, std::uint64_t row) {
    while (const auto line = lines_.next())
      if (!trimmed(*line).empty()) return *line;
    failCutShort(file_, element, row);
  }

  double nextNumber(std::string_view& rest, const PlyElement& element, std::size_t found) {
    const std::string_view word = nextWord(rest);
    const auto number = numberIn(word);
    if (number) return *number;
    const FilePlace where{file_, linesBefore_ + lines_.number()};
    if (word.empty())
      throw ShownError({Shown::tr("expected %1 numbers, found %2"),
                        {std::to_string(element.properties.size()), std::to_string(found)},
                        where});
    throw ShownError({Shown::tr("expected a number, found %1"), {inQuotes(word)}, where});
  }

  LineStream lines_;
  std::size_t linesBefore_;
  const std::string& file_;
};

/// pre: `rows` stand at the first row of `vertices`
template <class Rows>
RawPoints readVertices(Rows& rows, const PlyElement& vertices, std::vector<Station> stations,
                       std::uint64_t leastSize, const std::string& file, const ReadOptions& options,
                       const Progress& progress) {
  const std::vector<PointField> fields = fieldsOf(vertices, file);
  checkPromise(FilePlace{file}, vertices.count, leastSize, rows.left());
  PartChooser chooser(options);
  PointCollector points(fields, vertices.count, chooser);
  PointValues values{};
  for (std::uint64_t row = 0; row < vertices.count; ++row) {
    if (row % 65536 == 0)
      progress.update(static_cast<double>(row) / static_cast<double>(vertices.count));
    rows.read(vertices, row, fields, values);
    points.add(values);
  }
  return std::move(points).finish(hasFractions(vertices, fields), std::move(stations));
}

std::vector<ShownMessage> notesOn(const PlyHeader& header, const std::string& file) {
  for (const PlyElement& element : header.elements)
    if (element.name == "face" && element.count > 0)
      return {{element.count == 1
                   ? Shown::tr("is a mesh: 1 face left out, its corners are taken as points")
                   : Shown::tr("is a mesh: %1 faces left out, its corners are taken as points"),
               {std::to_string(element.count)},
               FilePlace{file}}};
  return {};
}

} // namespace

bool isPly(std::string_view beginning) {
  return beginning.starts_with("ply\n") || beginning.starts_with("ply\r");
}

ImportedPoints readPly(std::istream& in, const std::string& file, const ReadOptions& options,
                       const Progress& progress) {
  constexpr std::uint64_t longestHeader = std::uint64_t{1} << 24;
  ByteSource source(in);
  const std::string head = source.read(0, longestHeader);
  const PlyHeader header = readPlyHeader(head, file);
  const auto vertices = std::ranges::find(header.elements, "vertex", &PlyElement::name);
  if (vertices == header.elements.end())
    throw ShownError({Shown::tr("has no element 'vertex', so no points"), {}, FilePlace{file}});
  const auto read = [&](auto rows, std::uint64_t leastSize) {
    std::for_each(header.elements.begin(), vertices, [&](const auto& other) { rows.skip(other); });
    return readVertices(rows, *vertices, stationsIn(header.comments), leastSize, file, options,
                        progress);
  };
  // A number in text takes a digit and a blank; the last line may lack its end.
  const auto leastText = std::max<std::uint64_t>(2 * vertices->properties.size(), 2) - 1;
  const auto leastBinary = std::max<std::uint64_t>(vertices->leastSize(), 1);
  RawPoints points =
      header.isAscii
          ? read(AsciiRows(LineStream(source, header.dataStart), header.lines, file), leastText)
          : read(BinaryRows(ByteStream(source, header.dataStart), header.order, file), leastBinary);
  return {{std::move(points), notesOn(header, file)}, vertices->count};
}

void writePly(std::ostream& out, const PointCloud& cloud, const Eigen::Matrix3Xf& positions,
              const Progress& progress) {
  assert(positions.cols() == cloud.size());
  out << "ply\nformat binary_little_endian 1.0\ncomment made by Espalier\n";
  for (std::size_t i = 0; i < cloud.stations().size(); ++i)
    out << "comment " << stationComment(i, cloud.stations()[i]) << '\n';
  out << "element vertex " << cloud.size()
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  if (!cloud.colors().empty())
    out << "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  if (!cloud.intensities().empty()) out << "property float intensity\n";
  if (!cloud.stationOf().empty()) out << "property ushort station\n";
  out << "end_header\n";
  constexpr std::size_t blockSize = std::size_t{1} << 20;
  std::string block;
  const std::vector<Eigen::Index> order = pointsInFileOrder(cloud, progress.part(0, 0.2));
  const Progress writing = progress.part(0.2, 1);
  std::size_t written = 0;
  for (const Eigen::Index point : order) {
    const Eigen::Vector3d position = positions.col(point).cast<double>() + cloud.origin();
    for (const double coordinate : position)
      appendValue(block, coordinate);
    const auto i = static_cast<std::size_t>(point);
    if (!cloud.colors().empty())
      for (const std::uint8_t byte : cloud.colors()[i])
        appendValue(block, byte);
    if (!cloud.intensities().empty()) appendValue(block, cloud.intensities()[i]);
    if (!cloud.stationOf().empty()) appendValue(block, cloud.stationOf()[i]);
    ++written;
    if (block.size() < blockSize) continue;
    out << block;
    block.clear();
    writing.update(static_cast<double>(written) / static_cast<double>(order.size()));
  }
  out << block;
  writing.update(1);
}

} // namespace espalier
