#include "ui/panels/density_fields.h"

#include "ui/panels/option_field.h"

namespace espalier {

DensityFields::DensityFields(DensityCurve& curve, OptionField& least, OptionField& most,
                             OptionField& exponent)
    : QObject(&curve), curve_(curve), least_(least), most_(most), exponent_(exponent) {
  for (const OptionField* field : {&least_, &most_, &exponent_})
    connect(field, &OptionField::changed, this, &DensityFields::follow);
  connect(&curve_, &DensityCurve::changed, this, &DensityFields::take);
}

void DensityFields::setScale(const PlantScale& scale, const QString& unit) {
  scale_ = scale;
  const auto [leastExponent, mostExponent] = exponent_.option().range(scale);
  curve_.setLimits({.least = least_.option().range(scale).first, .exponent = leastExponent},
                   {.most = most_.option().range(scale).second, .exponent = mostExponent}, unit,
                   scale.spacing);
  curve_.setDefault({.least = least_.option().rule.value(scale),
                     .most = most_.option().rule.value(scale),
                     .exponent = exponent_.option().rule.value(scale)});
  follow();
}

void DensityFields::follow() {
  curve_.setCurve({.least = least_.value(), .most = most_.value(), .exponent = exponent_.value()});
}

/// What stands at its default follows the rule again.
void DensityFields::take(const DensityCurve::Curve& curve) {
  const auto set = [&](OptionField& field, double value) {
    if (value == field.value()) return;
    if (value == field.option().rule.value(scale_))
      field.choose(std::nullopt);
    else
      field.choose(value);
  };
  set(least_, curve.least);
  set(most_, curve.most);
  set(exponent_, curve.exponent);
}

} // namespace espalier
