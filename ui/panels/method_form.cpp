#include "ui/panels/method_form.h"

#include "ui/document/shown_text.h"
#include "ui/panels/density_curve.h"
#include "ui/panels/density_fields.h"
#include "ui/panels/option_field.h"

#include <QGridLayout>
#include <QLabel>

namespace espalier {

MethodForm::MethodForm(const Method& method, QWidget* parent) : QWidget(parent), method_(method) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(0, 1);
  auto* help = new QLabel(shownText(method.help), this);
  help->setWordWrap(true);
  help->setProperty("role", "quiet");
  if (!method.source.empty()) help->setToolTip(tr("Source: %1").arg(method.source.c_str()));
  grid->addWidget(help, 0, 0, 1, 2);
  const std::vector<Option>& options = method.options;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (i + 2 < options.size() && options[i + 2].kind == OptionKind::curve) addCurve(*grid);
    addField(options[i], *grid);
    if (options[i].kind == OptionKind::curve) tieCurve();
  }
}

void MethodForm::setScale(const PlantScale& scale, const QString& unit) {
  for (OptionField* field : fields_)
    field->setScale(scale, unit);
  if (curveFields_ != nullptr) curveFields_->setScale(scale, unit);
}

void MethodForm::setDensities(const std::vector<float>& densities) {
  if (curve_ != nullptr) curve_->setDensities(densities);
}

std::vector<double> MethodForm::values() const {
  std::vector<double> values;
  values.reserve(fields_.size());
  for (const OptionField* field : fields_)
    values.push_back(field->value());
  return values;
}

void MethodForm::addField(const Option& option, QGridLayout& grid) {
  fields_.push_back(OptionField::make(option, grid, *this));
  connect(fields_.back(), &OptionField::changed, this, &MethodForm::changed);
}

void MethodForm::addCurve(QGridLayout& grid) {
  curve_ = new DensityCurve(this);
  grid.addWidget(curve_, grid.rowCount(), 0, 1, 2);
}

/// The last field is that of the exponent, those before it of the two ends.
void MethodForm::tieCurve() {
  const auto exponent = fields_.end() - 1;
  curveFields_ = new DensityFields(*curve_, **(exponent - 2), **(exponent - 1), **exponent);
}

} // namespace espalier
