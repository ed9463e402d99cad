#pragma once

#include "core/pipeline/option_table.h"
#include "ui/panels/density_curve.h"

#include <QObject>

namespace espalier {

class OptionField;

/// Ties a density curve to the fields of its three numbers: what is set in one shows in the other.
/// Owned by the curve.
class DensityFields : public QObject {
  Q_OBJECT

public:
  DensityFields(DensityCurve& curve, OptionField& least, OptionField& most, OptionField& exponent);

  void setScale(const PlantScale& scale, const QString& unit);

private:
  void follow();
  void take(const DensityCurve::Curve& curve);

  DensityCurve& curve_;
  OptionField& least_;
  OptionField& most_;
  OptionField& exponent_;
  PlantScale scale_{.spacing = 1, .height = 100};
};

} // namespace espalier
