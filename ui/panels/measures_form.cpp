#include "ui/panels/measures_form.h"

#include <QGridLayout>
#include <QLabel>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr int columns = 5; // of the table by height

QString twoDigits(double length, LengthUnit unit) {
  return formatLength(length, unit, 2);
}

/// "4.0 mm (2.1 to 8.0)"
QString textOf(const Spread& spread, LengthUnit unit) {
  const auto plain = [](double length) { return twoDigits(length, LengthUnit::unknown); };
  return MeasuresForm::tr("%1 (%2 to %3)")
      .arg(twoDigits(spread.median, unit), plain(spread.low), plain(spread.high));
}

QString percent(double share) {
  return QStringLiteral("%1 %").arg(std::lround(100 * share));
}

QString gapsText(const std::vector<double>& gaps, LengthUnit unit) {
  if (gaps.empty()) return MeasuresForm::tr("none");
  return MeasuresForm::tr("%1, the widest %2")
      .arg(formatCount(gaps.size()), twoDigits(gaps.back(), unit));
}

QLabel* labelOf(const QString& text, const QString& help, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setToolTip(help);
  return label;
}

/// One line: what the rules of lengths follow from.
QString summaryOf(const ScanMeasures& measures, LengthUnit unit) {
  QStringList parts = {MeasuresForm::tr("points %1 apart").arg(twoDigits(measures.spacing, unit))};
  const WoodMeasures& whole = measures.whole;
  if (whole.thickness)
    parts.append(MeasuresForm::tr("wood %1").arg(twoDigits(whole.thickness->median, unit)));
  if (whole.scatter)
    parts.append(MeasuresForm::tr("scatter %1").arg(twoDigits(*whole.scatter, unit)));
  return parts.join(QStringLiteral(", "));
}

} // namespace

std::vector<MeasureText> measureTexts(const ScanMeasures& measures, LengthUnit unit) {
  std::vector<MeasureText> texts;
  const WoodMeasures& whole = measures.whole;
  const auto add = [&](const QString& name, const QString& value, const QString& help) {
    texts.push_back({name, value, help});
  };
  if (whole.spacing)
    add(MeasuresForm::tr("Points apart"), textOf(*whole.spacing, unit),
        MeasuresForm::tr("From a point to the nearest other: for half of the points it is less "
                         "than the first number; for a tenth it is less than the second, and for "
                         "a tenth more than the third. Point spacings of options are their mean, "
                         "%1.")
            .arg(twoDigits(measures.spacing, unit)));
  if (whole.scatter)
    add(MeasuresForm::tr("Scatter"),
        MeasuresForm::tr("%1, %2 spacings")
            .arg(twoDigits(*whole.scatter, unit),
                 twoDigits(*whole.scatter / measures.spacing, LengthUnit::unknown)),
        MeasuresForm::tr("How far points lie off the surface of the wood (standard deviation): the "
                         "noise of the scan"));
  if (whole.thickness)
    add(MeasuresForm::tr("Wood is thick"), textOf(*whole.thickness, unit),
        MeasuresForm::tr("How thick the wood around points is, noise included: at half of them "
                         "less than the first number; at a tenth less than the second, and at a "
                         "tenth more than the third. It was measured at %1 of the points: "
                         "elsewhere the wood branches, is close to other wood, or is more than "
                         "some 16 point spacings thick.")
            .arg(percent(whole.measured)));
  if (whole.arc)
    add(MeasuresForm::tr("Seen around"),
        QStringLiteral("%1°").arg(std::lround(*whole.arc * 180 / std::numbers::pi)),
        MeasuresForm::tr("How far around wood there are points, where it is at least 3 point "
                         "spacings thick: 360° is all around"));
  add(MeasuresForm::tr("Gaps"), gapsText(whole.gaps, unit),
      MeasuresForm::tr("Places wider than 8 point spacings without points, which part the plant"));
  if (whole.foliage)
    add(MeasuresForm::tr("Foliage"),
        MeasuresForm::tr("%1 of the points").arg(percent(*whole.foliage)),
        MeasuresForm::tr("Points that look like those of leaves and needles. The step Leaves "
                         "leaves them out."));
  return texts;
}

MeasuresForm::MeasuresForm(QWidget* parent)
    : QWidget(parent), header_(new QToolButton(this)), summary_(new QLabel(this)),
      body_(new QWidget(this)), grid_(new QGridLayout(body_)) {
  setObjectName("scan_measures");
  header_->setObjectName("scan_measures_header");
  header_->setText(tr("What the scan is like"));
  header_->setToolTip(
      tr("What is measured on the points: how far they are apart, how they scatter, "
         "how thick the wood is, how far around it was seen, gaps and foliage"));
  header_->setProperty("role", "step");
  header_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  header_->setCheckable(true);
  header_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  summary_->setObjectName("scan_measures_summary");
  summary_->setProperty("role", "quiet");
  summary_->setContentsMargins(28, 0, 12, 4);
  summary_->setWordWrap(true);
  grid_->setContentsMargins(28, 4, 12, 12);
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(4);
  grid_->setColumnStretch(columns - 1, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(header_);
  column->addWidget(summary_);
  column->addWidget(body_);
  connect(header_, &QToolButton::toggled, this, &MeasuresForm::setOpen);
  setOpen(false);
  showNone();
}

void MeasuresForm::setOpen(bool isOpen) {
  header_->setChecked(isOpen);
  header_->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
  body_->setVisible(isOpen && isMeasured_);
  summary_->setVisible(!isOpen || !isMeasured_);
}

void MeasuresForm::showNone() {
  isMeasured_ = false;
  setVisible(false);
}

void MeasuresForm::showMeasuring() {
  isMeasured_ = false;
  summary_->setText(tr("being measured…"));
  setVisible(true);
  setOpen(header_->isChecked());
}

void MeasuresForm::showMeasured(const ScanMeasures& measures, LengthUnit unit) {
  isMeasured_ = true;
  summary_->setText(summaryOf(measures, unit));
  fill(measures, unit);
  setVisible(true);
  setOpen(header_->isChecked());
}

void MeasuresForm::fill(const ScanMeasures& measures, LengthUnit unit) {
  while (QLayoutItem* item = grid_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  int row = 0;
  for (const MeasureText& text : measureTexts(measures, unit)) {
    grid_->addWidget(labelOf(text.name, text.help, body_), row, 0, 1, 2);
    QLabel* value = labelOf(text.value, text.help, body_);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid_->addWidget(value, row, 2, 1, columns - 2);
    ++row;
  }
  if (!measures.slabs.empty()) fillSlabs(measures, unit, row);
}

/// The highest slab above, as it stands.
void MeasuresForm::fillSlabs(const ScanMeasures& measures, LengthUnit unit, int row) {
  const QString in = unit == LengthUnit::unknown ? QString() : " [" + symbol(unit) + "]";
  const std::pair<QString, QString> heads[columns] = {
      {tr("From") + in, tr("Where the slab begins, along the axis that points up")},
      {tr("Apart"), tr("From a point to the nearest other, median")},
      {tr("Scatter"), tr("How far points lie off the surface of the wood")},
      {tr("Wood"), tr("How thick the wood is, median")},
      {tr("Foliage"), tr("Share of the points that look like those of leaves and needles")}};
  int column = 0;
  for (const auto& [name, help] : heads) {
    QLabel* head = labelOf(name, help, body_);
    head->setProperty("role", "quiet");
    grid_->addWidget(head, row, column++);
  }
  const QString none = QStringLiteral("–");
  const auto plain = [&](const std::optional<double>& length) {
    return length ? twoDigits(*length, LengthUnit::unknown) : none;
  };
  const auto median = [](const std::optional<Spread>& spread) {
    return spread ? std::optional(spread->median) : std::nullopt;
  };
  for (auto slab = measures.slabs.rbegin(); slab != measures.slabs.rend(); ++slab) {
    const WoodMeasures& its = slab->measures;
    const QString texts[columns] = {formatLength(slab->from, LengthUnit::unknown, 3),
                                    plain(median(its.spacing)), plain(its.scatter),
                                    plain(median(its.thickness)),
                                    its.foliage ? percent(*its.foliage) : none};
    ++row;
    for (int i = 0; i < columns; ++i)
      grid_->addWidget(labelOf(texts[i], heads[i].second, body_), row, i);
  }
}

} // namespace espalier
