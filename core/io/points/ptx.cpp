#include "core/io/points/ptx.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/io/bytes/line_stream.h"
#include "core/io/points/point_collector.h"
#include "core/io/points/station_points.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace espalier {
namespace {

constexpr std::array<std::size_t, 10> numbersOfHeader = {1, 1, 3, 3, 3, 3, 4, 4, 4, 4}; // by line
constexpr std::size_t scannerLine = 2;
constexpr std::size_t matrixStart = 6; // its line

/// What stands before the points of a block.
struct PtxHeader {
  std::uint64_t points = 0;
  Eigen::Matrix3d turn;
  Eigen::Vector3d shift;
  Eigen::Vector3d scanner; // where it stood
};

struct PtxCounts {
  std::uint64_t listed = 0;
  std::uint64_t empty = 0; // of those, directions without a return
};

std::vector<PointField> fieldsOfLine(std::size_t numbers) {
  using enum PointField;
  switch (numbers) {
  case 3:
    return {x, y, z};
  case 4:
    return {x, y, z, intensity};
  case 6:
    return {x, y, z, red, green, blue};
  case 7:
    return {x, y, z, intensity, red, green, blue};
  default:
    return {};
  }
}

/// Reads the blocks of a PTX file one after another.
class PtxReader {
public:
  PtxReader(ByteSource& source, const std::string& file, PartChooser& chooser,
            const Progress& progress)
      : lines_(source), file_(file), chooser_(chooser), progress_(progress) {}

  /// Moves on to the next line that is not blank; whether there is one.
  bool advance() {
    do {
      if (lines_.number() % 65536 == 0)
        progress_.update(static_cast<double>(lines_.offset()) /
                         static_cast<double>(std::max<std::uint64_t>(lines_.size(), 1)));
      const auto line = lines_.next();
      if (!line) return false;
      line_ = *line;
    } while (trimmed(line_).empty());
    return true;
  }

  /// Adds the points of a block. pre: advance() found its first line
  void readBlock(StationPoints& stations);
  [[nodiscard]] const PtxCounts& counts() const { return counts_; }

private:
  PtxHeader readHeader();
  void addPoint(const PtxHeader& header, std::uint64_t left);
  std::uint64_t sizeIn(double number) const;
  void readNumbers(std::size_t least, std::size_t most);
  [[nodiscard]] FilePlace here() const { return {file_, lines_.number()}; }

  LineStream lines_;
  const std::string& file_;
  PartChooser& chooser_;
  const Progress& progress_;
  std::string_view line_;
  std::vector<double> numbers_;          // of this line
  std::vector<PointField> fields_;       // of this block, by its first return:
  std::optional<PointCollector> points_; // lines without a return may be shorter
  PtxCounts counts_;
};

/// Takes the numbers of this line, up to `most` of them.
void PtxReader::readNumbers(std::size_t least, std::size_t most) {
  numbers_.clear();
  std::string_view rest = line_;
  while (numbers_.size() < most) {
    const std::string_view word = nextWord(rest);
    if (word.empty()) break;
    const auto number = numberIn(word);
    if (!number)
      throw ShownError({Shown::tr("expected a number, found %1"), {inQuotes(word)}, here()});
    numbers_.push_back(*number);
  }
  if (numbers_.size() < least)
    throw ShownError({Shown::tr("expected %1 numbers, found %2"),
                      {std::to_string(least), std::to_string(numbers_.size())},
                      here()});
}

std::uint64_t PtxReader::sizeIn(double number) const {
  if (!(number >= 0 && number <= std::numeric_limits<std::uint32_t>::max() &&
        std::floor(number) == number))
    throw ShownError({Shown::tr("expected a whole number of columns or rows, found %1"),
                      {inQuotes(trimmed(line_))},
                      here()});
  return static_cast<std::uint64_t>(number);
}

PtxHeader PtxReader::readHeader() {
  std::array<std::uint64_t, 2> sizes{};
  Eigen::Vector3d scanner;
  Eigen::Matrix<double, 4, 3> matrix;
  for (std::size_t i = 0; i < numbersOfHeader.size(); ++i) {
    if (i > 0 && !advance())
      throw ShownError(
          {Shown::tr("ends within the header of a block: it is cut short, copy or export it again"),
           {},
           FilePlace{file_}});
    readNumbers(numbersOfHeader[i], numbersOfHeader[i]);
    if (i < sizes.size()) sizes[i] = sizeIn(numbers_[0]);
    if (i == scannerLine) scanner = {numbers_[0], numbers_[1], numbers_[2]};
    if (i >= matrixStart)
      matrix.row(static_cast<Eigen::Index>(i - matrixStart)) =
          Eigen::RowVector3d(numbers_[0], numbers_[1], numbers_[2]);
  }
  const PtxHeader header{sizes[0] * sizes[1], matrix.topRows<3>().transpose(),
                         matrix.row(3).transpose(),
                         // Some writers leave it 0 and say it by the matrix alone.
                         scanner.isZero(0) ? Eigen::Vector3d(matrix.row(3).transpose()) : scanner};
  const double volume = std::abs(header.turn.determinant());
  if (!(volume > 0) || !matrix.allFinite())
    throw ShownError({Shown::tr("the matrix that ends here makes all points flat: the header is "
                                "damaged, export it again"),
                      {},
                      here()});
  return header;
}

void PtxReader::readBlock(StationPoints& stations) {
  const PtxHeader header = readHeader();
  constexpr std::size_t shortestLine = 5; // "0 0 0", of the last line
  constexpr std::size_t most = 7;
  checkPromise(here(), header.points, shortestLine, lines_.size() - lines_.offset());
  points_.reset();
  for (std::uint64_t i = 0; i < header.points; ++i) {
    if (!advance())
      throw ShownError({Shown::tr("ends after %1 of %2 points of its last block: it is cut short, "
                                  "copy or export it again"),
                        {std::to_string(i), std::to_string(header.points)},
                        FilePlace{file_}});
    readNumbers(3, most);
    if (numbers_[0] == 0 && numbers_[1] == 0 && numbers_[2] == 0) {
      ++counts_.empty;
      chooser_.pass();
    } else {
      addPoint(header, header.points - i);
    }
  }
  counts_.listed += header.points;
  const Station station{.name = {}, .scanner = header.scanner};
  if (!points_) return stations.add({}, {}, station);
  points_->reduce();
  const std::vector<std::uint64_t> ranks = points_->ranks();
  stations.add(std::move(*points_).finish(true), ranks, station);
}

void PtxReader::addPoint(const PtxHeader& header, std::uint64_t left) {
  if (!points_) {
    fields_ = fieldsOfLine(numbers_.size());
    if (fields_.empty())
      throw ShownError(
          {Shown::tr("expected x y z, intensity and red green blue, 4 or 7 numbers, found %1"),
           {std::to_string(numbers_.size())},
           here()});
    points_.emplace(fields_, left, chooser_);
  }
  if (numbers_.size() != fields_.size())
    throw ShownError({Shown::tr("expected %1 numbers as in the lines before, found %2"),
                      {std::to_string(fields_.size()), std::to_string(numbers_.size())},
                      here()});
  const Eigen::Vector3d position =
      header.turn * Eigen::Vector3d(numbers_[0], numbers_[1], numbers_[2]) + header.shift;
  std::copy_n(position.data(), 3, numbers_.begin());
  PointValues values{};
  for (std::size_t i = 0; i < fields_.size(); ++i)
    values[indexOf(fields_[i])] = numbers_[i];
  points_->add(values);
}

/// Whether a line holds so many numbers and nothing else.
bool holdsNumbers(std::string_view line, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    if (!numberIn(nextWord(line))) return false;
  return nextWord(line).empty();
}

} // namespace

bool isPtx(std::string_view beginning) {
  LineReader lines(beginning);
  return std::ranges::all_of(numbersOfHeader, [&](std::size_t count) {
    const auto line = lines.next();
    return line && holdsNumbers(*line, count);
  });
}

ImportedPoints readPtx(std::istream& in, const std::string& file, const ReadOptions& options,
                       const Progress& progress) {
  ByteSource source(in);
  PartChooser chooser(options);
  PtxReader reader(source, file, chooser, progress);
  StationPoints stations(chooser);
  while (reader.advance())
    reader.readBlock(stations);
  ImportedPoints result{std::move(stations).finish(file), reader.counts().listed};
  if (const PtxCounts& counts = reader.counts(); counts.empty > 0)
    result.notes.push_back({Shown::tr("%1 of %2 points have no return (0 0 0) and are left out"),
                            {std::to_string(counts.empty), std::to_string(counts.listed)},
                            FilePlace{file}});
  return result;
}

} // namespace espalier
