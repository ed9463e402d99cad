#include "tests/core/io/samples.h"

#include "core/io/structures/graphml.h"
#include "core/io/structures/node_list.h"
#include "core/io/structures/opf.h"
#include "core/io/structures/rsml.h"
#include "core/io/structures/swc.h"
#include "core/io/structures/treefile.h"
#include "core/mtg/mtg_writer.h"
#include "tests/support/plants.h"

#include <array>
#include <sstream>

namespace espalier::test {
namespace {

/// Writes `value` over the bytes from `at` on.
template <class T> void put(std::string& bytes, std::size_t at, T value) {
  std::string raw;
  appendValue(raw, value);
  bytes.replace(at, raw.size(), raw);
}

constexpr std::array<std::size_t, 11> recordLengths = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
constexpr std::array<std::size_t, 11> colorStarts = {0, 0, 20, 28, 0, 28, 0, 30, 30, 0, 30};

std::string lasRecord(const LasSample& sample, int i) {
  const auto format = static_cast<std::size_t>(sample.format);
  std::string record(recordLengths[format] + sample.extraBytes, '\x55');
  put<std::int32_t>(record, 0, 1000 + i);
  put<std::int32_t>(record, 4, 2000 + 2 * i);
  put<std::int32_t>(record, 8, 3 * i);
  put<std::uint16_t>(record, 12, static_cast<std::uint16_t>(100 + i));
  const bool isWithheld = i == sample.withheld;
  put<std::uint8_t>(record, 15,
                    sample.format < 6 ? (isWithheld ? 0x82 : 0x02) : (isWithheld ? 4 : 0));
  if (const std::size_t start = colorStarts[format]; start > 0)
    for (std::size_t c = 0; c < 3; ++c)
      put<std::uint16_t>(
          record, start + 2 * c,
          static_cast<std::uint16_t>((10 * (static_cast<int>(c) + 1) + i) * sample.colorUnit));
  return record;
}

std::string structureFile(void (*write)(std::ostream&, const Skeleton&)) {
  std::ostringstream out;
  write(out, randomPlant(12, 1));
  return out.str();
}

} // namespace

std::string lasFile(const LasSample& sample) {
  constexpr std::array<std::size_t, 5> headerSizes = {227, 227, 227, 235, 375};
  const std::size_t headerSize = headerSizes[static_cast<std::size_t>(sample.minorVersion)];
  const std::uint64_t count =
      sample.promised > 0 ? sample.promised : static_cast<std::uint64_t>(sample.points);
  std::string bytes(headerSize, '\0');
  bytes.replace(0, 4, "LASF");
  put<std::uint8_t>(bytes, 24, 1);
  put<std::uint8_t>(bytes, 25, static_cast<std::uint8_t>(sample.minorVersion));
  put<std::uint16_t>(bytes, 94, static_cast<std::uint16_t>(headerSize));
  put<std::uint32_t>(bytes, 96, static_cast<std::uint32_t>(headerSize + 54));
  put<std::uint32_t>(bytes, 100, 1); // variable length records: one, without content
  put<std::uint8_t>(bytes, 104, static_cast<std::uint8_t>(sample.format | sample.formatBits));
  put<std::uint16_t>(bytes, 105, static_cast<std::uint16_t>(lasRecord(sample, 0).size()));
  // Formats 6 to 10 have no legacy count.
  if (sample.format < 6) put<std::uint32_t>(bytes, 107, static_cast<std::uint32_t>(count));
  for (std::size_t axis = 0; axis < 3; ++axis)
    put<double>(bytes, 131 + 8 * axis, 0.001);
  put<double>(bytes, 155, 500000);
  put<double>(bytes, 163, 4000000);
  put<double>(bytes, 171, 100);
  if (sample.minorVersion == 4) put<std::uint64_t>(bytes, 247, count);
  bytes += std::string(54, '\0');
  for (int i = 0; i < sample.points; ++i)
    bytes += lasRecord(sample, i);
  return bytes;
}

std::string plyFile(std::endian order) {
  std::string bytes = "ply\nformat binary_";
  bytes += order == std::endian::big ? "big" : "little";
  bytes +=
      "_endian 1.0\ncomment a sample\nobj_info a sample\nelement camera 2\n"
      "property list uchar int16 view\nproperty char kind\nelement vertex 3\n"
      "property short x\nproperty uint8 flag\nproperty int y\nproperty list int8 float32 extra\n"
      "property double z\nproperty uint u\nproperty ushort red\nproperty uint16 green\n"
      "property ushort blue\nproperty float scalar_Intensity\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  const auto append = [&](auto value) { appendValue(bytes, value, order); };
  for (int camera = 0; camera < 2; ++camera) {
    append(static_cast<std::uint8_t>(camera + 1));
    for (int i = 0; i <= camera; ++i)
      append(static_cast<std::int16_t>(i));
    append(static_cast<std::int8_t>(-1));
  }
  for (int i = 0; i < 3; ++i) {
    append(static_cast<std::int16_t>(-1 - i));
    append(static_cast<std::uint8_t>(255));
    append(static_cast<std::int32_t>(100000 + i));
    append(static_cast<std::int8_t>(i));
    for (int item = 0; item < i; ++item)
      append(1.5F);
    append(0.25 * i);
    append(static_cast<std::uint32_t>(4000000000U));
    for (const int c : {10 + i, 20, 30})
      append(static_cast<std::uint16_t>(c * 256));
    append(0.5F * static_cast<float>(i));
  }
  append(static_cast<std::uint8_t>(3));
  for (int i = 0; i < 3; ++i)
    append(std::int32_t{i});
  return bytes;
}

std::string asciiPlyFile() {
  return "ply\r\nformat ascii 1.0\r\nelement camera 1\r\nproperty list uchar int view\r\n"
         "element vertex 3\r\nproperty float64 x\r\nproperty list uchar int extra\r\n"
         "property float y\r\nproperty float z\r\nproperty float red\r\nproperty float green\r\n"
         "property float blue\r\nend_header\r\n3 1 2 3\r\n"
         "500000.125 2 7 7 1 2 0 0.5 1\r\n-1e-3 0 2 3 0 0 0\r\n4 1 9 5 6 1 1 1\r\n";
}

std::string pcdFile(PcdKind kind) {
  constexpr std::array<const char*, 3> names = {"ascii", "binary", "binary_compressed"};
  std::string bytes =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
      "FIELDS x y z normal rgb intensity\nSIZE 4 4 4 4 4 2\nTYPE F F F F F U\n"
      "COUNT 1 1 1 3 1 1\nWIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA ";
  bytes += names[static_cast<std::size_t>(kind)];
  bytes += '\n';
  const auto color = [](int i) {
    return static_cast<std::uint32_t>(200 << 16 | 100 << 8 | (10 + i));
  };
  if (kind == PcdKind::ascii) {
    std::ostringstream text;
    text.precision(9);
    for (int i = 0; i < 3; ++i)
      text << 1 + i << " 2.5 " << -i << " 0 0 1 " << std::bit_cast<float>(color(i)) << ' ' << 7 * i
           << '\n';
    return bytes + text.str();
  }
  std::array<std::string, 6> fields;
  std::string records;
  for (int i = 0; i < 3; ++i) {
    std::array<std::string, 6> record;
    appendValue(record[0], static_cast<float>(1 + i));
    appendValue(record[1], 2.5F);
    appendValue(record[2], static_cast<float>(-i));
    for (const float value : {0.0F, 0.0F, 1.0F})
      appendValue(record[3], value);
    appendValue(record[4], color(i));
    appendValue(record[5], static_cast<std::uint16_t>(7 * i));
    for (std::size_t field = 0; field < 6; ++field) {
      fields[field] += record[field];
      records += record[field];
    }
  }
  if (kind == PcdKind::binary) return bytes + records;
  // Packed by hand: literal runs of at most 32 bytes, and one copy of the y of the first point.
  std::string unpacked;
  for (const std::string& field : fields)
    unpacked += field;
  std::string packed;
  const auto literal = [&](std::size_t from, std::size_t length) {
    packed += static_cast<char>(length - 1);
    packed += unpacked.substr(from, length);
  };
  literal(0, 16);   // all x, the first y
  packed += '\xc0'; // copy 8 bytes ...
  packed += '\x03'; // ... from 4 back: the y of the others
  for (std::size_t from = 24; from < unpacked.size(); from += 32)
    literal(from, std::min<std::size_t>(32, unpacked.size() - from));
  appendValue(bytes, static_cast<std::uint32_t>(packed.size()));
  appendValue(bytes, static_cast<std::uint32_t>(unpacked.size()));
  return bytes + packed;
}

std::string xyzFile() {
  return "//X Y Z Intensity R G B\n1.5 2 3 0.5 10 20 30\n-4 5e2 6 1 40 50 60\n"
         "# a remark\n7 8 9 1.5 70 80 90\n";
}

std::string ptxFile() {
  const std::string scanner = "2\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  return scanner +
         "0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1\n1 0 0 0.5 10 20 30\n0 1 0 0.25 1 2 3\n"
         "0 0 0 0.5 0 0 0\n0 0 1 1 255 0 0\n" +
         scanner +
         "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n1 2 3 0.5\n4 5 6 0.25\n7 8 9 0\n1e-3 0 0 1\n";
}

std::string geomFile() {
  return R"(# -Geom File-
(# of a test,
   on two lines #)

PointSet cloud {
    PointList [
        <1,2,3>,
        <4,5,6>
    ]
    ColorList [ <10,20,30,0>, <40,50,60,0> ]
    Width 2
}

Material bark { # as wood
    Ambient <81,64,43>
    Diffuse 2.65432
}

Shape leaf {
    Id 7
    Geometry Translated { Translation <10,0,0> Geometry cloud }
    Appearance bark
}

Shape {
    Geometry Group {
        GeometryList [ cloud, Sphere { Radius 0.5 } ]
    }
    Appearance Material { Ambient Red }
}
)";
}

std::string mtgFile() {
  return structureFile(writeMtg);
}

std::string nodeListFile() {
  return structureFile(writeNodeList);
}

std::string swcFile() {
  return structureFile(writeSwc);
}

std::string treefileFile() {
  return structureFile(writeTreefile);
}

std::string graphmlFile() {
  return structureFile(writeGraphml);
}

std::string opfFile() {
  return structureFile(writeOpf);
}

std::string rsmlFile() {
  return structureFile(writeRsml);
}

} // namespace espalier::test
