#include "ui/panels/traits_panel.h"

#include "ui/document/plant_document.h"
#include "ui/document/shown_message.h"
#include "ui/document/shown_text.h"
#include "ui/panels/label_role.h"
#include "ui/panels/panel_button.h"
#include "ui/panels/trait_text.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>

namespace espalier {
namespace {

/// The groups that stand below each other, column by column; what is by order has a table.
const std::vector<QStringList>& columns() {
  static const std::vector<QStringList> names = {
      {"Size"}, {"Stem", "Wood"}, {"Crown", "Branching", "Light"}};
  return names;
}

QGridLayout* gridIn(QWidget& group, const QString& name, int across) {
  auto* grid = new QGridLayout(&group);
  grid->setContentsMargins(0, 0, 0, 8);
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(2);
  auto* title = makeLabel("", "quiet");
  title->setText(name);
  grid->addWidget(title, 0, 0, 1, across);
  return grid;
}

} // namespace

TraitsPanel::TraitsPanel(const PlantDocument& document, const Parts& parts, QWidget* parent)
    : QWidget(parent), document_(document), density_(new QDoubleSpinBox),
      hint_(makeLabel("evaluation_hint", "quiet")),
      warnings_(makeLabel("traits_warnings", "warning")), area_(new QScrollArea) {
  setObjectName("traits_panel");
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(0, 0, 0, 0);
  page->setSpacing(4);
  page->addWidget(makeHead(parts));
  warnings_->setWordWrap(true);
  warnings_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  page->addWidget(warnings_);
  hint_->setAlignment(Qt::AlignCenter);
  page->addWidget(hint_, 1);
  area_->setObjectName("traits");
  area_->setAccessibleName(tr("Traits of the plant"));
  area_->setFrameShape(QFrame::NoFrame);
  area_->setWidgetResizable(true);
  page->addWidget(area_, 1);
  forget();
}

QWidget* TraitsPanel::makeHead(const Parts& parts) {
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  title_ = makeLabel("traits_title", "title");
  title_->setText(tr("The plant by itself"));
  row->addWidget(title_);
  row->addStretch();
  density_->setObjectName("wood_density");
  density_->setAccessibleName(tr("Density of the wood"));
  density_->setPrefix(tr("Wood "));
  density_->setSuffix(QStringLiteral(" kg/m³"));
  density_->setToolTip(tr("Dry mass of a cubic meter of wood, for biomass; none is assumed. The "
                          "unit of the plant must be known"));
  density_->setRange(leastDensity - 1, mostDensity);
  density_->setDecimals(0);
  density_->setSingleStep(10);
  density_->setKeyboardTracking(false);
  density_->setSpecialValueText(tr("Wood: no density"));
  connect(density_, &QDoubleSpinBox::valueChanged, this, &TraitsPanel::densityChosen);
  row->addWidget(density_);
  QToolButton* light = panelButton(*parts.light, tr("Measure Light"));
  light->setObjectName("traits_light");
  row->addWidget(light);
  QToolButton* report = panelButton(*parts.report, tr("Report…"));
  report->setObjectName("traits_report");
  row->addWidget(report);
  QToolButton* beside = panelButton(*parts.beside);
  beside->setObjectName("evaluation_beside");
  const auto showBeside = [beside, action = parts.beside] {
    beside->setVisible(action->isVisible());
  };
  connect(parts.beside, &QAction::changed, beside, showBeside);
  row->addWidget(beside);
  showBeside();
  auto* load = new QPushButton(tr("Load Reference…"));
  load->setObjectName("evaluation_load");
  connect(load, &QPushButton::clicked, parts.load, &QAction::trigger);
  row->addWidget(load);
  return head;
}

void TraitsPanel::show(const PlantMeasures& measures, bool isLightStale) {
  hint_->hide();
  title_->show();
  values_.clear();
  area_->setWidget(makePage(measures, isLightStale)); // the one before is deleted
  area_->show();
  QStringList lines;
  for (const ShownMessage& warning : measures.warnings)
    lines.append(QStringLiteral("⚠ ") + shownText(warning));
  warnings_->setText(lines.join('\n'));
  warnings_->setVisible(!lines.isEmpty());
}

void TraitsPanel::forget(const QString& why) {
  values_.clear();
  area_->hide();
  warnings_->hide();
  title_->hide();
  hint_->setText(!why.isEmpty()
                     ? why
                     : tr("Reconstruct the scan, or open a structure: its traits are shown here.\n"
                          "Load a reference to see how the two agree."));
  hint_->show();
}

void TraitsPanel::setDensity(double density) {
  const QSignalBlocker blocker(density_);
  density_->setValue(density);
}

void TraitsPanel::setStale(bool isStale) {
  for (QLabel* value : values_)
    setRole(*value, isStale ? "quiet" : "value");
}

QWidget* TraitsPanel::makePage(const PlantMeasures& measures, bool isLightStale) {
  auto* page = new QWidget;
  page->setObjectName("traits_page");
  auto* across = new QHBoxLayout(page);
  across->setContentsMargins(0, 4, 8, 0);
  across->setSpacing(18);
  std::vector<TraitRow> rows = traitRows(measures);
  for (const QStringList& groups : columns()) {
    auto* column = new QVBoxLayout;
    column->setSpacing(4);
    for (const QString& group : groups) {
      std::vector<TraitRow> ofGroup;
      std::ranges::copy_if(rows, std::back_inserter(ofGroup),
                           [&](const TraitRow& row) { return row.group == group.toStdString(); });
      if (ofGroup.empty()) continue;
      QWidget* made = makeGroup(group, ofGroup);
      if (group == QLatin1String("Light") && isLightStale) {
        made->setToolTip(tr("Of the plant before it was changed: measure it again"));
        for (QLabel* value : made->findChildren<QLabel*>())
          setRole(*value, "quiet");
      }
      column->addWidget(made);
    }
    column->addStretch();
    across->addLayout(column);
  }
  auto* last = new QVBoxLayout;
  last->addWidget(makeAxes(measures.traits));
  for (const CompartmentTable& table : compartments(measures))
    last->addWidget(makeCompartments(table, measures.density.isKnown()));
  last->addStretch();
  across->addLayout(last);
  across->addStretch();
  return page;
}

QWidget* TraitsPanel::makeGroup(const QString& name, const std::vector<TraitRow>& rows) {
  auto* group = new QWidget;
  QGridLayout* grid = gridIn(*group, shownText(name.toStdString()), 2);
  int place = 1;
  for (const TraitRow& row : rows) {
    QString text = numberedText(row.label);
    text[0] = text[0].toUpper();
    const QString help = shownText(row.help);
    auto* label = new QLabel(text);
    label->setToolTip(help);
    grid->addWidget(label, place, 0);
    grid->addWidget(makeValue(text, textOf(row, document_.unit()), help), place++, 1);
  }
  return group;
}

/// A table of its own: a line for each order.
QWidget* TraitsPanel::makeAxes(const Traits& traits) {
  const std::vector<AxisTraits>& axes = traits.axes;
  const std::vector<AngleSummary>& angles = traits.angles.byOrder; // from order 1 on
  auto* group = new QWidget;
  QGridLayout* grid = gridIn(*group, tr("Axes by order"), 5);
  const QStringList titles = {tr("Order"), tr("Axes"), tr("Mean length"), tr("Leave at"),
                              tr("Branching angle")};
  const QStringList helps = {tr("How many branchings lie between the axis and the root"),
                             tr("How many there are"), tr("Along the axis"),
                             tr("Where on what bears them: 0 at its foot, 1 at its tip"),
                             tr("Mean, between branches of this order and what bears them")};
  for (int column = 0; column < titles.size(); ++column) {
    auto* title = new QLabel(titles[column]);
    title->setToolTip(helps[column]);
    title->setAlignment(Qt::AlignRight);
    grid->addWidget(title, 1, column);
  }
  const auto add = [&](int row, int column, const QString& text) {
    const QString name =
        column == 0 ? titles[0] : tr("%1, order %2").arg(titles[column]).arg(row - 2);
    grid->addWidget(makeValue(name, text, helps[column]), row, column);
  };
  const QString none = QStringLiteral("–");
  for (std::size_t order = 0; order < axes.size(); ++order) {
    const int row = static_cast<int>(order) + 2;
    add(row, 0, QString::number(order));
    add(row, 1, formatCount(axes[order].count));
    add(row, 2, formatLength(axes[order].meanLength, document_.unit(), 3));
    add(row, 3,
        order == 0 ? none : formatLength(axes[order].meanInsertion, LengthUnit::unknown, 2));
    const bool hasAngle = order > 0 && order <= angles.size();
    add(row, 4,
        hasAngle
            ? textOf({.kind = TraitKind::angle, .value = angles[order - 1].mean}, document_.unit())
            : none);
  }
  return group;
}

QString TraitsPanel::nameOf(const Compartment& row) const {
  if (!row.name.empty()) return QString::fromStdString(row.name);
  if (!row.upTo) return tr("over %1").arg(formatLength(*row.from, document_.unit(), 3));
  return tr("to %1").arg(formatLength(*row.upTo, document_.unit(), 3));
}

/// A line for each class of organs.
QWidget* TraitsPanel::makeCompartments(const CompartmentTable& table, bool hasBiomass) {
  auto* group = new QWidget;
  group->setObjectName("compartments");
  using Kind = CompartmentTable::Kind;
  const QString what = table.kind == Kind::order      ? tr("Order")
                       : table.kind == Kind::diameter ? tr("Diameter")
                                                      : tr("Class");
  const QString title = table.kind == Kind::order ? tr("Wood by order")
                        : table.kind == Kind::diameter
                            ? tr("Wood by diameter")
                            : tr("Wood by class, scale %1").arg(table.scale);
  QStringList titles = {what, tr("Length"), tr("Volume")};
  if (hasBiomass) titles.append(tr("Biomass"));
  QGridLayout* grid = gridIn(*group, title, static_cast<int>(titles.size()));
  for (int column = 0; column < titles.size(); ++column) {
    auto* label = new QLabel(titles[column]);
    label->setAlignment(Qt::AlignRight);
    grid->addWidget(label, 1, column);
  }
  int line = 2;
  for (const Compartment& row : table.rows) {
    const QString name = nameOf(row);
    const auto add = [&](int column, const QString& text) {
      grid->addWidget(
          makeValue(tr("%1, %2 %3").arg(titles[column], what.toLower(), name), text, {}), line,
          column);
    };
    add(0, name);
    add(1, formatLength(row.wood.length, document_.unit(), 3));
    add(2, formatVolume(row.wood.volume, document_.unit()));
    if (row.biomass) add(3, formatLength(*row.biomass, LengthUnit::unknown, 3) + tr(" kg"));
    ++line;
  }
  return group;
}

QLabel* TraitsPanel::makeValue(const QString& name, const QString& text, const QString& help) {
  auto* value = makeLabel("trait_value", "value");
  value->setText(text);
  value->setToolTip(help);
  value->setAccessibleName(name);
  value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  values_.append(value);
  return value;
}

} // namespace espalier
