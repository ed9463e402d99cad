#include "ui/panels/inspector_panel.h"

#include "core/skeleton/axes.h"
#include "ui/document/number_box.h"
#include "ui/document/number_scale.h"
#include "ui/document/plant_document.h"
#include "ui/panels/cross_section_panel.h"
#include "ui/panels/focus_keys.h"
#include "ui/panels/radius_text.h"
#include "ui/panels/units_form.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// Digits after the point that show a radius to about four figures.
int decimalsFor(double radius) {
  if (radius <= 0) return 4;
  return std::clamp(3 - static_cast<int>(std::floor(std::log10(radius))), 0, 7);
}

QString describe(const Eigen::Vector3d& place) {
  const auto number = [](double value) { return numberText(value, 3); };
  return QStringLiteral("%1\n%2\n%3").arg(number(place.x()), number(place.y()), number(place.z()));
}

QLabel* makeValue(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

} // namespace

InspectorPanel::InspectorPanel(PlantDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), title_(new QLabel(this)),
      empty_(new QLabel(
          tr("Click a node to see it here, or press an arrow key.\nShift+click adds more."), this)),
      body_(new QWidget(this)), form_(new QFormLayout(body_)), order_(makeValue(body_)),
      edge_(new QComboBox(body_)), parent_(new QPushButton(body_)), children_(makeValue(body_)),
      position_(makeValue(body_)), length_(makeValue(body_)), radius_(new NumberBox(body_)),
      origin_(makeValue(body_)), section_(new CrossSectionPanel(document, this)),
      units_(new UnitsForm(document)) {
  makeForm();
  auto* page = new QWidget;
  page->setObjectName("inspector_page");
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(12, 12, 8, 12);
  column->setSpacing(12);
  column->addWidget(title_);
  column->addWidget(empty_);
  column->addWidget(body_);
  column->addWidget(section_);
  column->addWidget(units_);
  column->addStretch(1);
  auto* scroll = new QScrollArea; // units may have many features, and windows be low
  scroll->setWidget(page);
  scroll->setAccessibleName(tr("Inspector"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroll);
  connect(units_, &UnitsForm::typed, this, &InspectorPanel::unitTyped);
  connect(units_, &UnitsForm::featureRequested, this, &InspectorPanel::featureRequested);
  connect(units_, &UnitsForm::dateRequested, this, &InspectorPanel::dateRequested);
  connect(units_, &UnitsForm::leaveRequested, this, &InspectorPanel::leaveRequested);
  connect(edge_, &QComboBox::activated, this,
          [this] { emit edgeChosen(edge_->currentData().value<EdgeType>()); });
  connect(radius_, &QDoubleSpinBox::valueChanged, this, &InspectorPanel::radiusTyped);
  connect(radius_->findChild<QLineEdit*>(), &QLineEdit::returnPressed, this,
          &InspectorPanel::leaveRequested);
  connect(parent_, &QPushButton::clicked, this, [this] {
    const std::optional<NodeId> current = document_.selection().current();
    if (current && document_.skeleton()[*current].parent)
      emit nodeChosen(*document_.skeleton()[*current].parent);
  });
  connect(&document_.selection(), &Selection::changed, this, &InspectorPanel::refresh);
  connect(&document_, &PlantDocument::skeletonEdited, this, &InspectorPanel::refresh);
  connect(&document_, &PlantDocument::skeletonReplaced, this, &InspectorPanel::refresh);
  connect(&document_, &PlantDocument::unitChanged, this, &InspectorPanel::refresh);
  refresh();
}

void InspectorPanel::makeForm() {
  title_->setProperty("role", "title");
  empty_->setProperty("role", "quiet");
  empty_->setWordWrap(true);
  opensOnEnter(*edge_);
  edge_->addItem(tr("< axial"), QVariant::fromValue(EdgeType::successor));
  edge_->addItem(tr("+ branching"), QVariant::fromValue(EdgeType::branching));
  parent_->setObjectName("node_parent");
  parent_->setProperty("role", "link");
  parent_->setFlat(true);
  parent_->setCursor(Qt::PointingHandCursor);
  parent_->setToolTip(tr("Select the parent"));
  radius_->setKeyboardTracking(false); // one edit, when the number is complete
  radius_->setRange(0, 1e9);
  radius_->setObjectName("node_radius");
  radius_->setButtonSymbols(QAbstractSpinBox::NoButtons); // keys A and Q step it
  radius_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  origin_->setObjectName("radius_origin");
  origin_->setWordWrap(true);
  origin_->setToolTip(tr("Where the radius is from. The true one lies between these bounds with a "
                         "probability of 90 %, if they are known."));
  // What a node has to show must not widen the panel: the view would shift under the pointer.
  for (QWidget* field :
       {static_cast<QWidget*>(title_), static_cast<QWidget*>(radius_),
        static_cast<QWidget*>(origin_), static_cast<QWidget*>(edge_), static_cast<QWidget*>(order_),
        static_cast<QWidget*>(parent_), static_cast<QWidget*>(children_),
        static_cast<QWidget*>(length_), static_cast<QWidget*>(position_)}) {
    field->setMinimumWidth(72);
    field->setSizePolicy(QSizePolicy::Ignored, field->sizePolicy().verticalPolicy());
  }
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form_->setContentsMargins(0, 0, 0, 0);
  form_->setHorizontalSpacing(8);
  form_->setVerticalSpacing(8);
  form_->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
  form_->addRow(tr("Radius"), radius_);
  form_->addRow(tr("From"), origin_);
  form_->addRow(tr("Edge"), edge_);
  form_->addRow(tr("Order"), order_);
  form_->addRow(tr("Parent"), parent_);
  form_->addRow(tr("Children"), children_);
  form_->addRow(tr("Length"), length_);
  form_->addRow(tr("Position"), position_);
  auto* place = static_cast<QLabel*>(form_->labelForField(position_));
  place->setAlignment(Qt::AlignLeft | Qt::AlignTop); // a form makes it higher beside three lines
}

void InspectorPanel::refresh() {
  const QSignalBlocker quiet(radius_); // a number that is typed there is taken as it hides
  Selection& selection = document_.selection();
  const bool isStale = std::ranges::any_of(selection.nodes(), [this](NodeId id) {
    return !document_.skeleton().contains(id); // removed; the selection drops it next
  });
  const bool hasNode = !selection.isEmpty() && !isStale;
  body_->setVisible(hasNode);
  title_->setVisible(hasNode);
  empty_->setVisible(!hasNode);
  const bool isOne = hasNode && selection.nodes().size() == 1;
  if (isOne)
    units_->show(selection.nodes().front());
  else
    units_->showNothing();
  if (!hasNode) return;
  for (QWidget* widget : {static_cast<QWidget*>(edge_), static_cast<QWidget*>(order_),
                          static_cast<QWidget*>(parent_), static_cast<QWidget*>(children_),
                          static_cast<QWidget*>(length_), static_cast<QWidget*>(position_)}) {
    widget->setVisible(isOne);
    form_->labelForField(widget)->setVisible(isOne);
  }
  const QString unit = symbol(document_.unit());
  radius_->setSuffix(unit.isEmpty() ? QString() : QChar(0x202f) + unit);
  if (isOne)
    showNode(selection.nodes().front());
  else
    showNodes();
}

void InspectorPanel::showNode(NodeId id) {
  const Skeleton& skeleton = document_.skeleton();
  const Node& node = skeleton[id];
  title_->setText(tr("Node %1").arg(indexOf(id)));
  showRadius(node.radius, tr("Radius"), {});
  showOrigin(originText(node, document_.unit()));
  order_->setText(QString::number(order(skeleton, id)));
  children_->setText(QString::number(skeleton.children(id).size()));
  position_->setText(describe(node.position));
  const int edge = edge_->findData(QVariant::fromValue(node.edge));
  edge_->setCurrentIndex(node.parent ? edge : -1); // a root has none
  edge_->setEnabled(node.parent.has_value());
  parent_->setEnabled(node.parent.has_value());
  parent_->setText(node.parent ? tr("Node %1").arg(indexOf(*node.parent)) : tr("root"));
  length_->setText(
      node.parent
          ? formatLength((node.position - skeleton[*node.parent].position).norm(), document_.unit())
          : QStringLiteral("–"));
}

void InspectorPanel::showNodes() {
  const std::vector<NodeId>& nodes = document_.selection().nodes();
  double sum = 0;
  bool isCommon = true;
  const double first = document_.skeleton()[nodes.front()].radius;
  for (const NodeId id : nodes) {
    const double radius = document_.skeleton()[id].radius;
    sum += radius;
    isCommon = isCommon && radius == first;
  }
  title_->setText(tr("%1 nodes").arg(formatCount(nodes.size())));
  showOrigin({});
  if (isCommon)
    showRadius(first, tr("Radius"), {});
  else
    showRadius(sum / static_cast<double>(nodes.size()), tr("Mean radius"),
               tr("The radii differ. A number typed here becomes the radius of all of them."));
}

void InspectorPanel::showRadius(double radius, const QString& name, const QString& help) {
  auto* label = static_cast<QLabel*>(form_->labelForField(radius_));
  label->setText(name);
  label->setToolTip(help);
  radius_->setToolTip(help);
  radius_->setDecimals(decimalsFor(radius));
  radius_->setValue(radius);
}

void InspectorPanel::showOrigin(const QString& text) {
  origin_->setText(text);
  form_->setRowVisible(origin_, !text.isEmpty());
}

} // namespace espalier
