#include "ui/view/scene_buffers.h"

#include "core/base/pieces.h"
#include "ui/view/drawing_order.h"
#include "ui/view/point_look.h"

#include <algorithm>
#include <array>
#include <vector>

namespace espalier {
namespace {

/// The columns or entries of `count` things in the order in which they are drawn.
template <class Value, class At> std::vector<Value> inDrawingOrder(Eigen::Index count, At at) {
  constexpr Eigen::Index grain = 1 << 14;
  std::vector<Value> values(static_cast<std::size_t>(count));
  const DrawingOrder order(count);
  runInPieces(count, grain, [&](Eigen::Index begin, Eigen::Index end) {
    Eigen::Index point = order.pointAt(begin);
    for (Eigen::Index rank = begin; rank < end; ++rank, point = order.after(point))
      values[static_cast<std::size_t>(rank)] = at(point);
  });
  return values;
}

/// Lines from where points were scanned to where they are now: of an even part of them, if they are
/// many.
void uploadDisplacements(GlBuffer& buffer, const Eigen::Matrix3Xf& scanned,
                         const Eigen::Matrix3Xf& positions) {
  constexpr std::size_t atMost = 30000;
  struct Line {
    std::array<float, 3> from;
    std::array<float, 3> to;
  };
  const auto placeIn = [](const Eigen::Matrix3Xf& places, Eigen::Index i) {
    return std::array<float, 3>{places(0, i), places(1, i), places(2, i)};
  };
  auto lines = inDrawingOrder<Line>(positions.cols(), [&](Eigen::Index i) {
    return Line{placeIn(scanned, i), placeIn(positions, i)};
  });
  lines.resize(std::min(lines.size(), atMost));
  buffer.upload(lines.data(), lines.size() * sizeof(Line));
}

void uploadPositions(GlBuffer& buffer, const Eigen::Matrix3Xf& positions) {
  using Place = std::array<float, 3>;
  const auto places = inDrawingOrder<Place>(positions.cols(), [&](Eigen::Index i) {
    return Place{positions(0, i), positions(1, i), positions(2, i)};
  });
  buffer.upload(places.data(), places.size() * sizeof(Place));
}

void uploadLooks(GlBuffer& buffer, const std::vector<PointLook>& looks) {
  const auto sorted =
      inDrawingOrder<PointLook>(static_cast<Eigen::Index>(looks.size()),
                                [&](Eigen::Index i) { return looks[static_cast<std::size_t>(i)]; });
  buffer.upload(sorted.data(), sorted.size() * sizeof(PointLook));
}

void upload(GlBuffer& buffer, DrawnLooks& looks, const Scene& scene) {
  looks.refresh(scene);
  buffer.upload(looks.inOrder().data(), looks.inOrder().size() * sizeof(PointLook));
}

/// Each glyph once for each of its corners. (Instances would need no copies, but software OpenGL
/// handles them one by one, which takes five times as long.)
template <class Glyph>
std::vector<Glyph> corners(const std::vector<Glyph>& glyphs, std::size_t begin, std::size_t end,
                           std::size_t spare = 0) {
  std::vector<Glyph> copies;
  copies.reserve(4 * (end - begin + spare));
  for (std::size_t i = begin; i < end; ++i)
    copies.insert(copies.end(), 4, glyphs[i]);
  copies.resize(4 * (end - begin + spare));
  return copies;
}

template <class Glyph>
void uploadChanges(GlBuffer& buffer, const std::vector<Glyph>& glyphs, const SlotRange& changed) {
  const std::size_t slot = 4 * sizeof(Glyph); // [bytes]
  const std::size_t needed = glyphs.size() * slot;
  if (buffer.size() < needed || buffer.size() > 2 * needed + 1024 * slot) {
    // Room for nodes to come: adding one does not move all others.
    const auto all = corners(glyphs, 0, glyphs.size(), glyphs.size() / 4 + 64);
    buffer.upload(all.data(), all.size() * sizeof(Glyph));
  } else if (!changed.isEmpty()) {
    const auto some = corners(glyphs, changed.begin, changed.end);
    buffer.write(some.data(), changed.begin * slot, some.size() * sizeof(Glyph));
  }
}

void upload(SceneBuffers::Glyphs& buffers, SkeletonGlyphs& glyphs) {
  uploadChanges(buffers.nodes, glyphs.nodes(), glyphs.takeChangedNodes());
  uploadChanges(buffers.edges, glyphs.edges(), glyphs.takeChangedEdges());
}

void uploadContracted(SceneBuffers::Points& buffers, const DrawnPoints& layer,
                      const Eigen::Matrix3Xf* scanned, const Scene& scene) {
  if (buffers.revision != layer.revision && layer.positions)
    uploadPositions(buffers.positions, *layer.positions);
  buffers.revision = layer.revision;
  const bool hasBoth = layer.positions && scanned && scanned->cols() == layer.size();
  if (!scene.displacementsShown || !hasBoth) {
    buffers.displacements.release();
    buffers.displacedRevision = 0;
  } else if (buffers.displacedRevision != layer.revision) {
    uploadDisplacements(buffers.displacements, *scanned, *layer.positions);
    buffers.displacedRevision = layer.revision;
  }
}

/// The looks of points that are a part of the cloud, if these are colored by value, or some of them
/// are selected, hidden, ... Before uploadContracted(), which takes note of the revision.
void uploadLooksOf(const OtherState& other, SceneBuffers::Points& buffers, const Scene& scene) {
  const bool areAlike = !scene.pointValues && !scene.pointStates;
  if (areAlike || other.points.empty()) return buffers.colors.release();
  const bool isNew = buffers.colors.size() == 0 || buffers.revision != other.contracted.revision ||
                     buffers.colorRevision != scene.colorRevision;
  if (!isNew) return;
  const PointLooks all(scene,
                       scene.pointValues ? PointPlace::scanned : PointPlace::contractedInState);
  std::vector<PointLook> looks;
  looks.reserve(other.points.size());
  for (const Eigen::Index point : other.points)
    looks.push_back(all[point]);
  uploadLooks(buffers.colors, looks);
  buffers.colorRevision = scene.colorRevision;
}

/// The colors of the points of the other scan, if it is colored by value.
void uploadMovedLooks(SceneBuffers::Points& buffers, const Scene& scene) {
  if (!scene.moved.shown.values) return buffers.colors.release();
  const std::uint64_t revision = scene.moved.colorRevision + scene.colorRevision; // both only grow
  if (buffers.colors.size() > 0 && buffers.colorRevision == revision) return;
  uploadLooks(buffers.colors, movedLooks(scene));
  buffers.colorRevision = revision;
}

} // namespace

void SceneBuffers::uploadPoints(const Scene& scene) {
  if (cloud_.revision != scene.points.revision && scene.points.positions)
    uploadPositions(cloud_.positions, *scene.points.positions);
  const bool areColorsNew = scene.cloud && cloud_.colorRevision != scene.colorRevision;
  if (areColorsNew) upload(cloud_.colors, looks_, scene);
  if (areColorsNew || contracted_.revision != scene.contracted.revision) {
    const bool isContracted = scene.cloud && scene.contracted.size() == scene.points.size();
    if (isContracted && (scene.pointStates || scene.areSomeAtRest)) {
      upload(contracted_.colors, contractedLooks_, scene);
    } else {
      contracted_.colors.release();
      contractedLooks_ = DrawnLooks(PointPlace::contracted);
    }
  }
  cloud_.revision = scene.points.revision;
  cloud_.colorRevision = scene.colorRevision;
  if (moved_.revision != scene.moved.revision && scene.moved.positions)
    uploadPositions(moved_.positions, *scene.moved.positions);
  moved_.revision = scene.moved.revision;
  uploadMovedLooks(moved_, scene);
  for (const Side side : {Side::left, Side::right})
    uploadLooksOf(scene.other(side), others_[static_cast<std::size_t>(side)].contracted, scene);
  uploadContracted(contracted_, scene.contracted, scene.points.positions.get(), scene);
  for (const Side side : {Side::left, Side::right}) {
    const OtherState& other = scene.other(side);
    Points& buffers = others_[static_cast<std::size_t>(side)].contracted;
    if (other.scanned && buffers.revision != other.contracted.revision)
      uploadPositions(buffers.scanned, *other.scanned);
    if (!other.scanned) buffers.scanned.release();
    uploadContracted(buffers, other.contracted,
                     other.scanned ? other.scanned.get() : scene.points.positions.get(), scene);
  }
}

void SceneBuffers::uploadSkeleton(Scene& scene) {
  upload(skeleton_, scene.skeleton);
}

void SceneBuffers::uploadOther(Scene& scene, Side side) {
  upload(others_[static_cast<std::size_t>(side)].skeleton, scene.other(side).skeleton);
}

void SceneBuffers::uploadReference(Scene& scene) {
  upload(reference_, scene.reference);
}

const GlBuffer& SceneBuffers::quads(std::size_t count) {
  if (quads_.size() < count * 6 * sizeof(std::uint32_t)) {
    std::vector<std::uint32_t> indices;
    const auto all = static_cast<std::uint32_t>(count + count / 4 + 64);
    indices.reserve(6 * std::size_t{all});
    for (std::uint32_t first = 0; first < 4 * all; first += 4)
      for (const std::uint32_t corner : {0, 1, 2, 2, 1, 3})
        indices.push_back(first + corner);
    quads_.upload(indices.data(), indices.size() * sizeof(std::uint32_t));
  }
  return quads_;
}

std::vector<GlBuffer*> SceneBuffers::all() {
  std::vector<GlBuffer*> buffers{&quads_};
  for (Points* points :
       {&cloud_, &contracted_, &moved_, &others_[0].contracted, &others_[1].contracted})
    buffers.insert(buffers.end(),
                   {&points->positions, &points->scanned, &points->colors, &points->displacements});
  for (Glyphs* glyphs : {&skeleton_, &reference_, &others_[0].skeleton, &others_[1].skeleton})
    buffers.insert(buffers.end(), {&glyphs->nodes, &glyphs->edges});
  return buffers;
}

std::size_t SceneBuffers::bytes() {
  std::size_t bytes = 0;
  for (const GlBuffer* buffer : all())
    bytes += buffer->size();
  return bytes;
}

void SceneBuffers::leave(bool isCurrent) {
  const int others = users_ - 1;
  if (others == 0 || !isCurrent) {
    for (GlBuffer* buffer : all())
      if (isCurrent) buffer->release();
    *this = {};
  }
  users_ = others;
}

} // namespace espalier
