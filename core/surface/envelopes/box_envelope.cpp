#include "core/surface/envelopes/box_envelope.h"

#include "core/base/shown.h"
#include "core/surface/envelopes/rings.h"

#include <numbers>

namespace espalier {

Envelope boxOf(const OutlineBox& box, double bottom, double top) {
  const Eigen::Vector2d across(-box.along.y(), box.along.x());
  const auto ringAt = [&](double z) {
    Ring ring;
    for (const auto& [a, b] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
      const Eigen::Vector2d at =
          box.middle + a * box.sides.x() * box.along + b * box.sides.y() * across;
      ring.emplace_back(at.x(), at.y(), z);
    }
    return ring;
  };
  const auto end = [&](double z) { return Eigen::Vector3d(box.middle.x(), box.middle.y(), z); };
  Envelope envelope = envelopeOf(meshOfRings(end(bottom), {ringAt(bottom), ringAt(top)}, end(top)));
  double azimuth = std::atan2(box.along.y(), box.along.x());
  if (azimuth <= -std::numbers::pi / 2) azimuth += std::numbers::pi;
  if (azimuth > std::numbers::pi / 2) azimuth -= std::numbers::pi;
  std::vector<EnvelopeParameter>& parameters = envelope.parameters;
  parameters.push_back({.name = "length", .label = Shown::tr("length"), .value = box.sides.x()});
  parameters.push_back({.name = "width", .label = Shown::tr("width"), .value = box.sides.y()});
  parameters.push_back({.name = "height", .label = Shown::tr("height"), .value = top - bottom});
  addPlace(parameters, "center", Shown::tr("center"), end((bottom + top) / 2));
  parameters.push_back({.name = "azimuth",
                        .label = Shown::tr("azimuth"),
                        .kind = EnvelopeParameter::Kind::angle,
                        .value = azimuth});
  return envelope;
}

Envelope boxEnvelope(const Crown& crown) {
  return boxOf(boxAround(outlineOf(crown)), bottomOf(crown), topOf(crown));
}

} // namespace espalier
