#include "core/io/points/copc_octree.h"

#include "core/base/shown_message.h"
#include "core/io/bytes/scalar.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace espalier {
namespace {

ShownError damagedOctree(const std::string& file) {
  return ShownError({Shown::tr("its octree (COPC) does not fit its points, so no part of them is "
                               "found: the file is damaged, copy or export it again"),
                     {},
                     FilePlace{file}});
}

/// What the record of COPC says.
struct CopcInfo {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double halfSide = 0; // of the root
  std::uint64_t pageStart = 0;
  std::uint64_t pageSize = 0; // bytes
};

CopcInfo copcInfoAt(const char* bytes) {
  CopcInfo info;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    info.center[axis] = valueAt<double>(bytes + 8 * axis);
  info.halfSide = valueAt<double>(bytes + 24);
  info.pageStart = valueAt<std::uint64_t>(bytes + 40);
  info.pageSize = valueAt<std::uint64_t>(bytes + 48);
  return info;
}

/// Reads the pages of the hierarchy of an octree.
class CopcPages {
public:
  CopcPages(ByteSource& source, const CopcInfo& info, double tolerance, const std::string& file)
      : source_(source), info_(info), tolerance_(tolerance), file_(file), left_(source.size()) {
    pages_.emplace_back(info.pageStart, info.pageSize);
  }

  /// The nodes that have points, by the place of their chunk in the file.
  [[nodiscard]] std::map<std::uint64_t, CopcNode> nodes() {
    while (!pages_.empty()) {
      const auto [start, size] = pages_.back();
      pages_.pop_back();
      if (size > left_) throw damagedOctree(file_); // pages lead in a circle
      left_ -= size;
      const std::string page = source_.read(start, size);
      if (page.size() != size) throw damagedOctree(file_);
      for (std::size_t at = 0; at + entrySize <= page.size(); at += entrySize)
        addEntry(page.data() + at);
    }
    return std::move(nodes_);
  }

private:
  static constexpr std::size_t entrySize = 32;

  void addEntry(const char* entry) {
    const auto place = valueAt<std::uint64_t>(entry + 16);
    const auto size = valueAt<std::int32_t>(entry + 24);
    const auto points = valueAt<std::int32_t>(entry + 28);
    if (points == 0) return;
    if (points > 0)
      nodes_[place] = nodeAt(entry);
    else
      pages_.emplace_back(place, static_cast<std::uint32_t>(size)); // with what is below the node
  }

  CopcNode nodeAt(const char* entry) const {
    constexpr std::uint32_t levels = 31;
    const auto level = valueAt<std::uint32_t>(entry);
    if (level >= levels) throw damagedOctree(file_);
    const double side = std::ldexp(2 * info_.halfSide, -static_cast<int>(level));
    Eigen::Vector3d corner;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      corner[axis] =
          info_.center[axis] - info_.halfSide + side * valueAt<std::int32_t>(entry + 4 + 4 * axis);
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(tolerance_);
    return {level, {corner - margin, corner + Eigen::Vector3d::Constant(side) + margin}};
  }

  ByteSource& source_;
  const CopcInfo& info_;
  double tolerance_; // [L], by which points may be rounded out of their cell
  const std::string& file_;
  std::uint64_t left_; // bytes of pages that may still be read
  std::vector<std::pair<std::uint64_t, std::uint64_t>> pages_; // start and size
  std::map<std::uint64_t, CopcNode> nodes_;
};

} // namespace

std::vector<CopcNode> copcNodesOf(ByteSource& source, const LasHeader& header,
                                  const LazLayout& layout, const std::string& file) {
  constexpr std::size_t infoSize = 160;
  const std::string head = source.read(0, header.pointStart);
  const std::string_view record = lasRecord(head, header, "copc", 1);
  if (record.size() < infoSize) return {};
  const CopcInfo info = copcInfoAt(record.data());
  const double tolerance = header.scale.cwiseAbs().maxCoeff();
  const auto nodes = CopcPages(source, info, tolerance, file).nodes();
  std::vector<CopcNode> result;
  for (const LazChunk& chunk : layout.chunks) {
    const auto node = nodes.find(chunk.start);
    if (node == nodes.end()) throw damagedOctree(file);
    result.push_back(node->second);
  }
  return result;
}

} // namespace espalier
