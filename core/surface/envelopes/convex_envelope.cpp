#include "core/surface/envelopes/convex_envelope.h"

#include "core/base/shown.h"
namespace espalier {

Envelope convexEnvelope(const Crown& crown) {
  SurfaceMesh mesh;
  for (const auto& corner : crown.hull.corners.colwise())
    mesh.corners.emplace_back(corner);
  mesh.triangles = crown.hull.triangles;
  const auto corners = static_cast<double>(mesh.corners.size());
  return envelopeOf(std::move(mesh),
                    {{"corners", Shown::tr("corners"), EnvelopeParameter::Kind::number, corners}});
}

} // namespace espalier
