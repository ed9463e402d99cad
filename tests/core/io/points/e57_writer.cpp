#include "tests/core/io/points/e57_writer.h"

#include "core/io/bytes/scalar.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <sstream>

namespace espalier::test {
namespace {

constexpr std::size_t pageBytes = 1024;
constexpr std::size_t contentBytes = 1020; // of a page

/// Bit by bit, as the polynomial is written: not as the reader does it.
std::uint32_t crcOf(std::string_view bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char byte : bytes) {
    crc ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit)
      crc = (crc & 1) != 0 ? (crc >> 1) ^ 0x82f63b78U : crc >> 1;
  }
  return ~crc;
}

std::uint64_t placeInFile(std::size_t inContent) {
  return inContent / contentBytes * pageBytes + inContent % contentBytes;
}

std::string number(double value) {
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

std::string elementOf(const E57Column& column) {
  const std::string limits = " minimum=\"" + std::to_string(column.minimum) + "\" maximum=\"" +
                             std::to_string(column.maximum) + '"';
  const std::string start = "<" + column.name + " type=\"";
  switch (column.packing) {
  case E57Packing::integer:
    return start + "Integer\"" + limits + "/>\n";
  case E57Packing::scaledInteger:
    return start + "ScaledInteger\"" + limits + " scale=\"" + number(column.scale) +
           "\" offset=\"" + number(column.offset) + "\"/>\n";
  case E57Packing::single:
    return start + "Float\" precision=\"single\"/>\n";
  case E57Packing::real:
    break;
  }
  return start + "Float\"/>\n";
}

unsigned widthOf(const E57Column& column) {
  if (column.packing == E57Packing::real) return 64;
  if (column.packing == E57Packing::single) return 32;
  return static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(column.maximum) -
                                              static_cast<std::uint64_t>(column.minimum)));
}

std::uint64_t packed(const E57Column& column, double value) {
  if (column.packing == E57Packing::real) return std::bit_cast<std::uint64_t>(value);
  if (column.packing == E57Packing::single)
    return std::bit_cast<std::uint32_t>(static_cast<float>(value));
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(value)) -
         static_cast<std::uint64_t>(column.minimum);
}

/// All values of a column, the lowest bit first.
std::string streamOf(const E57Column& column) {
  const unsigned width = widthOf(column);
  std::string bytes((column.values.size() * width + 7) / 8, '\0');
  std::size_t at = 0;
  for (const double value : column.values)
    for (unsigned bit = 0; bit < width; ++bit, ++at)
      if ((packed(column, value) >> bit & 1) != 0)
        bytes[at / 8] = static_cast<char>(bytes[at / 8] | 1 << at % 8);
  return bytes;
}

/// An index or an empty packet, which readers pass over.
std::string otherPacket(std::uint8_t type) {
  std::string packet;
  appendValue(packet, type);
  appendValue(packet, std::uint8_t{0});
  appendValue(packet, std::uint16_t{15}); // its length - 1
  return packet + std::string(12, '\x5a');
}

std::string dataPacket(const std::vector<std::string>& streams) {
  std::string rest;
  appendValue(rest, static_cast<std::uint16_t>(streams.size()));
  for (const std::string& stream : streams)
    appendValue(rest, static_cast<std::uint16_t>(stream.size()));
  for (const std::string& stream : streams)
    rest += stream;
  rest.resize((rest.size() + 3) / 4 * 4);
  std::string packet;
  appendValue(packet, std::uint8_t{1});
  appendValue(packet, std::uint8_t{0});
  appendValue(packet, static_cast<std::uint16_t>(4 + rest.size() - 1));
  return packet + rest;
}

std::string packetsOf(const E57Sample& sample) {
  std::vector<std::string> left;
  for (const E57Column& column : sample.columns)
    left.push_back(streamOf(column));
  std::string packets;
  bool isDone = false;
  while (!isDone) {
    isDone = true;
    std::vector<std::string> now;
    for (std::string& stream : left) {
      now.push_back(stream.substr(0, sample.bytesPerPacket));
      stream.erase(0, now.back().size());
      isDone = isDone && stream.empty();
    }
    packets += dataPacket(now) + otherPacket(2);
  }
  return otherPacket(0) + packets + otherPacket(0);
}

/// A section at this place of the content.
std::string sectionOf(const E57Sample& sample, std::size_t start) {
  constexpr std::size_t headerBytes = 32;
  const std::string packets = packetsOf(sample);
  std::string section("\1\0\0\0\0\0\0\0", 8);
  appendValue(section, static_cast<std::uint64_t>(headerBytes + packets.size()));
  appendValue(section, placeInFile(start + headerBytes));
  appendValue(section, std::uint64_t{0}); // no index
  return section + packets;
}

std::string describe(const E57Sample& sample, std::size_t start) {
  const std::size_t count = sample.columns.front().values.size();
  std::string text = "<vectorChild type=\"Structure\">\n" + sample.more +
                     "<points type=\"CompressedVector\" fileOffset=\"" +
                     std::to_string(placeInFile(start)) + "\" recordCount=\"" +
                     std::to_string(sample.promised > 0 ? sample.promised : count) +
                     "\">\n<prototype type=\"Structure\">\n";
  for (const E57Column& column : sample.columns)
    text += elementOf(column);
  return text + "</prototype>\n<codecs type=\"Vector\">" + sample.codecs +
         "</codecs>\n</points>\n</vectorChild>\n";
}

} // namespace

std::string e57File(const std::vector<E57Sample>& scans) {
  std::string content(48, '\0');
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<e57Root type=\"Structure\">\n"
                    "<data3D type=\"Vector\">\n";
  for (const E57Sample& scan : scans) {
    xml += describe(scan, content.size());
    content += sectionOf(scan, content.size());
  }
  xml += "</data3D>\n</e57Root>\n";
  return e57Pages(content + xml, content.size(), xml.size());
}

std::string e57Pages(std::string content, std::size_t xmlStart, std::size_t xmlSize) {
  content.resize((content.size() + contentBytes - 1) / contentBytes * contentBytes);
  std::string header = "ASTM-E57";
  appendValue(header, std::uint32_t{1});
  appendValue(header, std::uint32_t{0});
  for (const std::uint64_t value : {placeInFile(content.size()), placeInFile(xmlStart),
                                    std::uint64_t{xmlSize}, std::uint64_t{pageBytes}})
    appendValue(header, value);
  content.replace(0, header.size(), header);
  std::string file;
  for (std::size_t at = 0; at < content.size(); at += contentBytes)
    file += content.substr(at, contentBytes) + std::string(4, '\0');
  return withChecksums(std::move(file));
}

std::string e57Content(const std::string& file) {
  std::string content;
  for (std::size_t at = 0; at < file.size(); at += pageBytes)
    content += file.substr(at, contentBytes);
  return content;
}

std::string withChecksums(std::string file) {
  for (std::size_t at = 0; at + pageBytes <= file.size(); at += pageBytes) {
    std::string checksum;
    appendValue(checksum, crcOf(std::string_view(file).substr(at, contentBytes)), std::endian::big);
    file.replace(at + contentBytes, checksum.size(), checksum);
  }
  return file;
}

std::string healedE57(std::string file) {
  constexpr std::size_t sizeStart = 16; // in the header
  if (file.size() < 48) return file;
  file.resize((file.size() + pageBytes - 1) / pageBytes * pageBytes);
  std::string size;
  appendValue(size, std::uint64_t{file.size()});
  file.replace(sizeStart, size.size(), size);
  return withChecksums(std::move(file));
}

std::vector<E57Column> cartesianColumns(const std::vector<double>& x, const std::vector<double>& y,
                                        const std::vector<double>& z) {
  return {{.name = "cartesianX", .values = x},
          {.name = "cartesianY", .values = y},
          {.name = "cartesianZ", .values = z}};
}

std::string e57Pose(double w, double x, double y, double z, double moveX, double moveY,
                    double moveZ) {
  const auto element = [](const char* name, double value) {
    return std::string("<") + name + " type=\"Float\">" + number(value) + "</" + name + ">";
  };
  return "<pose type=\"Structure\"><rotation type=\"Structure\">" + element("w", w) +
         element("x", x) + element("y", y) + element("z", z) +
         "</rotation><translation type=\"Structure\">" + element("x", moveX) + element("y", moveY) +
         element("z", moveZ) + "</translation></pose>\n";
}

std::string e57SampleFile() {
  std::vector<double> counted;
  for (int i = 0; i < 20; ++i)
    counted.push_back(i);
  E57Sample first{.columns = cartesianColumns(counted, counted, counted),
                  .more = e57Pose(1, 0, 0, 0, 10, 20, 30)};
  first.columns[1].packing = E57Packing::single;
  first.columns[2] = {"cartesianZ", E57Packing::scaledInteger, counted, -100, 100, 0.001, 1};
  for (const char* name : {"colorRed", "colorGreen", "colorBlue"})
    first.columns.push_back({name, E57Packing::integer, counted, 0, 255});
  E57Sample second = first;
  second.columns[3] = {"intensity", E57Packing::integer, counted, 0, 31};
  second.columns[4] = {"cartesianInvalidState", E57Packing::integer, std::vector<double>(20), 0, 2};
  second.columns[5] = {"rowIndex", E57Packing::integer, counted, -5, 20};
  return e57File({first, second});
}

} // namespace espalier::test
