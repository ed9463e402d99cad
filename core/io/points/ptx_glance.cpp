// What PTX files hold.
#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/io/points/point_glances.h"
#include "core/io/points/point_samples.h"
#include "core/io/points/ptx.h"

#include <algorithm>
#include <array>

namespace espalier {
namespace {

constexpr std::uint64_t ptxHeadBytes = std::uint64_t{1} << 14;
constexpr std::size_t linesOfPtxHeader = 10;

std::vector<double> numbersIn(std::string_view line) {
  std::vector<double> numbers;
  while (const auto number = numberIn(nextWord(line)))
    numbers.push_back(*number);
  return numbers;
}

void addColumns(std::size_t numbers, PointGlance& glance) {
  for (const char* name : {"x", "y", "z"})
    glance.columns.push_back({name, "text", true});
  if (numbers == 4 || numbers == 7) glance.columns.push_back({"intensity", "text", true});
  if (numbers >= 6)
    for (const char* name : {"red", "green", "blue"})
      glance.columns.push_back({name, "text", true});
}

} // namespace

PointGlance glanceAtPtx(ByteSource& source, const std::string& file) {
  const std::string head = source.read(0, ptxHeadBytes);
  if (!isPtx(head))
    throw ShownError({Shown::tr("expected the header of a block of PTX, ten lines of numbers"),
                      {},
                      FilePlace{file, 1}});
  PointGlance glance;
  std::array<std::vector<double>, linesOfPtxHeader> header;
  LineReader lines(head);
  for (std::vector<double>& numbers : header)
    numbers = numbersIn(lines.next().value_or(""));
  std::size_t longest = 3;
  Eigen::Matrix<double, 4, 3> matrix;
  for (Eigen::Index row = 0; row < 4; ++row)
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      matrix(row, axis) = header[static_cast<std::size_t>(6 + row)][static_cast<std::size_t>(axis)];
  std::uint64_t headers = 0; // lines of one number, of which a block has two
  const LineSample sampled = sampleLines(source, lines.offset(), [&](std::string_view line) {
    const std::vector<double> numbers = numbersIn(line);
    if (numbers.size() == 1) ++headers;
    if (numbers.size() < 3) return false;
    longest = std::max(longest, std::min<std::size_t>(numbers.size(), 7));
    const Eigen::RowVector3d measured(numbers[0], numbers[1], numbers[2]);
    if (!measured.isZero(0))
      glance.sample.emplace_back((measured * matrix.topRows<3>() + matrix.row(3)).transpose());
    return true;
  });
  const double block = header[0].front() * header[1].front();
  const std::uint64_t listed = sampled.linesIn(source.size() - lines.offset());
  const bool isOneBlock = headers == 0 && static_cast<double>(listed) < 1.02 * block + 1;
  glance.version = {isOneBlock ? Shown::tr("grid of %1 x %2")
                               : Shown::tr("grid of %1 x %2 and others"),
                    {plainDecimal(header[0].front()), plainDecimal(header[1].front())}};
  glance.points = isOneBlock ? static_cast<std::uint64_t>(block) : listed;
  if (!isOneBlock && sampled.isAll) glance.points -= std::min(glance.points, 8 * (headers / 2));
  glance.arePointsEstimated = !isOneBlock && !sampled.isAll;
  glance.stations = isOneBlock ? 1 : sampled.isAll ? 1 + headers / 2 : 0;
  if (!isOneBlock) glance.sample.clear(); // of blocks with matrices of their own
  addColumns(longest, glance);
  glance.unit = {"m", {Shown::tr("PTX is in meters")}, true};
  glance.up = {"z", {Shown::tr("scanners that write PTX stand along z")}, true};
  return glance;
}

} // namespace espalier
