#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace espalier::test {

/// How the values of a field are packed.
enum class E57Packing : std::uint8_t { integer, scaledInteger, single, real };

/// A field of the records of a scan with its values, one for each record: of integers what is
/// packed, before scale and offset.
struct E57Column {
  std::string name = {};
  E57Packing packing = E57Packing::real;
  std::vector<double> values = {};
  std::int64_t minimum = 0;
  std::int64_t maximum = 0;
  double scale = 1;
  double offset = 0;
};

struct E57Sample {
  std::vector<E57Column> columns = {};
  std::string more = {};           // XML beside the points: a pose, limits of colors
  std::string codecs = {};         // XML that names them
  std::size_t bytesPerPacket = 64; // of each stream
  std::uint64_t promised = 0;      // records stated in the XML, 0: as many as there are
};

/// An E57 file of these scans. Between the packets of data stand some of an index and empty ones.
[[nodiscard]] std::string e57File(const std::vector<E57Sample>& scans);

/// A file with this content in its pages, and with these bytes of the content as its XML. The
/// header of 48 bytes is written over its beginning.
[[nodiscard]] std::string e57Pages(std::string content, std::size_t xmlStart, std::size_t xmlSize);

/// The content of a file: its pages without their checksums, e57Pages() for the other direction.
[[nodiscard]] std::string e57Content(const std::string& file);

/// The same file after what was changed in its content: the checksums fit it.
[[nodiscard]] std::string withChecksums(std::string file);

/// The same with a header that states its size, and whole pages, so that damage within the pages is
/// all that is wrong with it.
[[nodiscard]] std::string healedE57(std::string file);

/// x, y and z of these values, as doubles.
[[nodiscard]] std::vector<E57Column> cartesianColumns(const std::vector<double>& x,
                                                      const std::vector<double>& y,
                                                      const std::vector<double>& z);

/// The XML of a pose.
[[nodiscard]] std::string e57Pose(double w, double x, double y, double z, double moveX,
                                  double moveY, double moveZ);

/// Two stations of 20 points with intensities and colors: doubles, floats and scaled integers.
[[nodiscard]] std::string e57SampleFile();

} // namespace espalier::test
