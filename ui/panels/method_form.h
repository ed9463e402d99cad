#pragma once

#include "core/pipeline/registry.h"

#include <QWidget>

#include <vector>

class QGridLayout;

namespace espalier {

class DensityCurve;
class DensityFields;
class OptionField;

/// What a method does, and its options: made from its option table.
class MethodForm : public QWidget {
  Q_OBJECT

public:
  /// @param method outlives it
  explicit MethodForm(const Method& method, QWidget* parent = nullptr);

  void setScale(const PlantScale& scale, const QString& unit);
  /// Shown behind the curve of a method whose radius follows the density: normalized to [0, 1].
  void setDensities(const std::vector<float>& densities);

  [[nodiscard]] const Method& method() const { return method_; }
  [[nodiscard]] const std::vector<OptionField*>& fields() const { return fields_; }
  [[nodiscard]] std::vector<double> values() const; // one per option, for this scale

signals:
  void changed();

private:
  void addField(const Option& option, QGridLayout& grid);
  void addCurve(QGridLayout& grid);
  void tieCurve();

  const Method& method_;
  std::vector<OptionField*> fields_; // in the order of the options
  DensityCurve* curve_ = nullptr;    // of a method that has one
  DensityFields* curveFields_ = nullptr;
};

} // namespace espalier
