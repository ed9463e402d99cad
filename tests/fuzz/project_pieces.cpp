// Fuzz target: the pieces of a project whose hashes were made to fit. Whatever the bytes, they are
// refused or give a skeleton, a delta, points; those are whole, and written again are as they were.
#include "core/base/error.h"
#include "core/project/content_hash.h"
#include "core/project/history.h"
#include "core/project/node_bytes.h"
#include "core/project/point_bytes.h"

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

namespace espalier {
namespace {

constexpr std::size_t hashSize = 8;

/// Larger ids are read as well, but take gigabytes (see mostIds): too slow to try often.
constexpr std::size_t largestId = 1 << 16;

void require(bool holds, const char* what) {
  if (holds) return;
  std::cerr << what << '\n';
  std::abort();
}

/// The bytes with the hash at their end made right.
std::string hashed(std::string bytes) {
  if (bytes.size() < hashSize) return bytes;
  bytes.resize(bytes.size() - hashSize);
  const std::uint64_t hash = contentHash(bytes);
  for (std::size_t i = 0; i < hashSize; ++i)
    bytes.push_back(static_cast<char>(hash >> (8 * i) & 0xFF));
  return bytes;
}

/// The number of 32 bits behind the version: where the ids of a skeleton end.
std::size_t idEndIn(const std::string& bytes) {
  std::size_t end = 0;
  for (std::size_t i = 1; i < 5 && i < bytes.size(); ++i)
    end |= std::size_t{static_cast<std::uint8_t>(bytes[i])} << (8 * (i - 1));
  return end;
}

void readSkeleton(const std::string& bytes) {
  if (idEndIn(bytes) > largestId) return;
  const std::optional<StoredPlant> plant = plantFrom(bytes);
  if (!plant) return;
  for (const NodeId id : plant->skeleton.ids())
    require(plant->skeleton[id].radius >= 0, "a skeleton with a bad radius");
  const auto again = plantFrom(bytesOf(plant->skeleton, plant->leftOut, plant->organs));
  require(again && again->leftOut == plant->leftOut && again->organs == plant->organs,
          "a plant that is not read again");
}

void readDelta(const std::string& bytes) {
  const std::optional<StoredDelta> stored = deltaFrom(bytes);
  if (!stored) return;
  const auto again = deltaFrom(bytesOf(stored->delta, stored->points, stored->organs));
  require(again && again->points == stored->points && again->organs == stored->organs,
          "a delta that is not read again");
  const SkeletonDelta* const delta = &stored->delta;
  for (const SkeletonDelta::Change& change : delta->changes)
    if (indexOf(change.id) > largestId) return;
  Skeleton skeleton;
  (void)skeleton.add({});
  const std::size_t before = skeleton.size();
  if (!tryToApply(*delta, skeleton)) return require(skeleton.size() == before, "half an edit");
  require(tryToApply(delta->inverse(), skeleton), "an edit that cannot be undone");
  require(skeleton.size() == before, "an edit that is not undone");
}

void readPoints(const std::string& bytes) {
  try {
    const PointCloud cloud = cloudFrom(bytes);
    require(cloud.positions().allFinite(), "points that are not finite");
    require(bytesOf(cloud) == bytes, "points that are not written again as they were");
  } catch (const Error&) { // what a broken piece deserves
  }
  try {
    require(positionsFrom(bytes).allFinite(), "positions that are not finite");
  } catch (const Error&) { // likewise
  }
}

} // namespace
} // namespace espalier

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::string whole = espalier::hashed(bytes);
  espalier::readSkeleton(whole);
  espalier::readDelta(whole);
  espalier::readPoints(bytes);
  return 0;
}
