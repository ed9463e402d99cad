#include "app/report/envelope_numbers.h"

#include <nlohmann/json.hpp>

#include <numbers>
#include <utility>

namespace espalier {

nlohmann::ordered_json numbersOf(const Envelope& envelope) {
  nlohmann::ordered_json parameters = nlohmann::ordered_json::object();
  for (const EnvelopeParameter& parameter : envelope.parameters)
    parameters[parameter.name] = parameter.kind == EnvelopeParameter::Kind::angle
                                     ? parameter.value * 180 / std::numbers::pi
                                     : parameter.value;
  return {{"volume", envelope.volume},
          {"area", envelope.area},
          {"height", envelope.height},
          {"diameter", envelope.diameter},
          {"parameters", std::move(parameters)},
          {"mesh",
           {{"corners", envelope.mesh.corners.size()},
            {"triangles", envelope.mesh.triangles.size()},
            {"volume", volume(envelope.mesh)},
            {"area", area(envelope.mesh)}}}};
}

nlohmann::ordered_json numbersOf(const ReportedEnvelope& reported) {
  nlohmann::ordered_json json = {{"kind", reported.kind},
                                 {"of", reported.isOfSkeleton ? "skeleton" : "points"},
                                 {"by_hand", reported.isByHand}};
  json.update(numbersOf(reported.envelope));
  return json;
}

} // namespace espalier
