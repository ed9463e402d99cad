#include "core/io/points/xyz.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/cloud/file_order.h"
#include "core/io/bytes/line_stream.h"
#include "core/io/points/point_collector.h"
#include "core/io/points/xyz_layout.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <ostream>
#include <utility>

namespace espalier {
namespace {

/// Reads the fields of a line that are wanted.
/// @return whether they were all there; if not, the line may be a count
bool readRow(std::string_view line, const XyzLayout& layout, const std::string& file,
             std::size_t number, PointValues& values) {
  std::string_view rest = line;
  for (std::size_t i = 0; i < layout.needed; ++i) {
    const std::string_view field = nextField(rest, layout.separator);
    const auto value = numberInField(field, layout.hasDecimalComma);
    if (value) {
      values[indexOf(layout.columns[i])] = *value;
    } else if (layout.columns[i] != PointField::none || field.empty()) {
      const FilePlace where{file, number};
      if (!field.empty())
        throw ShownError({Shown::tr("expected a number, found %1"), {inQuotes(field)}, where});
      const bool isCount = trimmed(line).find_first_not_of("0123456789") == std::string_view::npos;
      if (i == 1 && isCount) return false;
      throw ShownError({Shown::tr("expected %1 numbers, found %2"),
                        {std::to_string(layout.needed), std::to_string(i)},
                        where});
    }
  }
  return true;
}

std::vector<ShownMessage> notesOn(const XyzLayout& layout, bool areNamed, std::uint64_t points,
                                  const std::string& file) {
  std::vector<ShownMessage> notes;
  const auto leftOut = std::ranges::count(layout.columns, PointField::none);
  if (leftOut > 0 && !areNamed)
    notes.push_back({Shown::tr("%1 of %2 columns are left out; a first line as 'x y z intensity r "
                               "g b' names columns"),
                     {std::to_string(leftOut), std::to_string(layout.columns.size())},
                     FilePlace{file}});
  if (layout.count && *layout.count > points)
    notes.push_back({Shown::tr("promises %1 points, but lists %2"),
                     {std::to_string(*layout.count), std::to_string(points)},
                     FilePlace{file}});
  return notes;
}

/// Writes numbers into a block of text and passes it on when it is full.
class BlockWriter {
public:
  explicit BlockWriter(std::ostream& out) : out_(out) {}

  template <class... Format> void number(auto value, Format... format) {
    std::array<char, 400> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...).ptr;
    block_.append(buffer.data(), end);
  }

  /// A coordinate with the fewest decimals for which it is `offset` from `origin` again.
  void coordinate(float offset, double origin) {
    const double value = static_cast<double>(offset) + origin;
    const double step = std::nextafter(std::abs(offset), INFINITY) - std::abs(offset);
    const int most = std::clamp(1 - static_cast<int>(std::floor(std::log10(step))), 0, 17);
    for (int decimals = std::max(0, most - 4); decimals <= most; ++decimals) {
      std::array<char, 400> buffer{};
      const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                     std::chars_format::fixed, decimals)
                           .ptr;
      std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
      if (static_cast<float>(*numberIn(text) - origin) != offset) continue;
      if (decimals > 0) {
        text = text.substr(0, text.find_last_not_of('0') + 1);
        if (text.ends_with('.')) text.remove_suffix(1);
      }
      block_ += text;
      return;
    }
    number(value, std::chars_format::fixed);
  }

  void text(std::string_view text) { block_ += text; }

  void flush(std::size_t limit = 0) {
    if (block_.size() < limit) return;
    out_ << block_;
    block_.clear();
  }

private:
  std::ostream& out_;
  std::string block_;
};

void writeNames(const PointCloud& cloud, BlockWriter& writer) {
  if (cloud.intensities().empty() && cloud.colors().empty()) return;
  writer.text("//X Y Z");
  if (!cloud.intensities().empty()) writer.text(" Intensity");
  if (!cloud.colors().empty()) writer.text(" R G B");
  writer.text("\n");
}

} // namespace

ImportedPoints readXyz(std::istream& in, const std::string& file, const ReadOptions& options,
                       const Progress& progress) {
  ByteSource source(in);
  const XyzLayout layout = xyzLayoutOf(source, file, options.columns);
  if (layout.columns.empty()) {
    if (layout.headerLine > 0)
      throw ShownError({Shown::tr("expected 3 numbers, found text, and no points follow"),
                        {},
                        FilePlace{file, layout.headerLine}});
    throw ShownError(
        {Shown::tr("holds no points, a line each of at least 3 numbers"), {}, FilePlace{file}});
  }
  constexpr std::size_t shortestLine = 6; // "0 0 0\n"
  PartChooser chooser(options);
  PointCollector points(
      layout.columns, std::min<std::uint64_t>(source.size() / shortestLine + 1, 1U << 20), chooser);
  LineStream lines(source);
  PointValues values{};
  while (const auto line = lines.next()) {
    if (lines.number() % 65536 == 0)
      progress.update(static_cast<double>(lines.offset()) / static_cast<double>(lines.size()));
    if (isComment(*line) || lines.number() == layout.headerLine) continue;
    if (readRow(*line, layout, file, lines.number(), values)) points.add(values);
  }
  ImportedPoints result{{std::move(points).finish(true), {}}, chooser.met()};
  result.notes = notesOn(layout, !options.columns.empty(), result.listed, file);
  return result;
}

void writeXyz(std::ostream& out, const PointCloud& cloud, const Eigen::Matrix3Xf& positions,
              const Progress& progress) {
  assert(positions.cols() == cloud.size());
  BlockWriter writer(out);
  writeNames(cloud, writer);
  const std::vector<Eigen::Index> order = pointsInFileOrder(cloud, progress.part(0, 0.2));
  const Progress writing = progress.part(0.2, 1);
  std::size_t written = 0;
  for (const Eigen::Index point : order) {
    constexpr std::size_t often = 8192; // points
    if (written++ % often == 0)
      writing.update(static_cast<double>(written) / static_cast<double>(order.size()));
    for (int axis = 0; axis < 3; ++axis) {
      if (axis > 0) writer.text(" ");
      writer.coordinate(positions(axis, point), cloud.origin()[axis]);
    }
    const auto i = static_cast<std::size_t>(point);
    if (!cloud.intensities().empty()) {
      writer.text(" ");
      writer.number(cloud.intensities()[i], std::chars_format::fixed);
    }
    if (!cloud.colors().empty())
      for (const std::uint8_t byte : cloud.colors()[i]) {
        writer.text(" ");
        writer.number(static_cast<int>(byte));
      }
    writer.text("\n");
    writer.flush(std::size_t{1} << 20);
  }
  writer.flush();
  writing.update(1);
}

} // namespace espalier
