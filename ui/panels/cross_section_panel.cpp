#include "ui/panels/cross_section_panel.h"

#include "core/skeleton/edits.h"
#include "ui/document/plant_document.h"
#include "ui/panels/focus_keys.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>
#include <numbers>
#include <utility>

namespace espalier {
namespace {

QString percent(double share) {
  return QString::number(std::lround(100 * share)) + QChar(0x202f) + '%';
}

} // namespace

QString nameOf(RadiusMeasure measure) {
  switch (measure) {
  case RadiusMeasure::mean:
    return CrossSectionPanel::tr("Mean");
  case RadiusMeasure::maximum:
    return CrossSectionPanel::tr("Maximum");
  case RadiusMeasure::hull:
    return CrossSectionPanel::tr("Hull");
  case RadiusMeasure::circle:
    break;
  }
  return CrossSectionPanel::tr("Circle");
}

QString reasonOf(NoRadius reason) {
  switch (reason) {
  case NoRadius::noSection:
    return CrossSectionPanel::tr("no direction");
  case NoRadius::fewPoints:
    return CrossSectionPanel::tr("too few points");
  case NoRadius::oneSided:
    return CrossSectionPanel::tr("points on one side only");
  case NoRadius::noCircle:
    break;
  }
  return CrossSectionPanel::tr("no circle in the points");
}

CrossSectionPanel::CrossSectionPanel(PlantDocument& document, QWidget* parent)
    : QWidget(parent), document_(document), view_(new CrossSectionView(this)),
      measure_(new QComboBox(this)), apply_(new QPushButton(tr("Apply"), this)),
      words_(new QLabel(this)) {
  makeForm();
  connect(view_, &CrossSectionView::circleAsked, this, &CrossSectionPanel::ask);
  connect(view_, &CrossSectionView::canceled, this,
          [this](Gesture gesture) { document_.cancel(gesture); });
  connect(view_, &CrossSectionView::dragEnded, this, [this] {
    if (node_) showSection(true);
  });
  connect(view_, &CrossSectionView::pointerInside, this, [this](bool isInside) {
    isPointerInside_ = isInside;
    emit ringChanged();
  });
  connect(measure_, &QComboBox::currentIndexChanged, this, &CrossSectionPanel::showProposed);
  connect(apply_, &QPushButton::clicked, this, &CrossSectionPanel::apply);
  connect(&document_.selection(), &Selection::changed, this, &CrossSectionPanel::refresh);
  for (auto signal : {&PlantDocument::skeletonReplaced, &PlantDocument::scanChanged,
                      &PlantDocument::leftOutChanged, &PlantDocument::unitChanged,
                      &PlantDocument::readOnlyChanged})
    connect(&document_, signal, this, &CrossSectionPanel::refresh);
  connect(&document_, &PlantDocument::skeletonEdited, this, &CrossSectionPanel::refresh);
  refresh();
}

void CrossSectionPanel::makeForm() {
  auto* title = new QLabel(tr("Cross-section"), this);
  title->setProperty("role", "section");
  for (const RadiusMeasure measure :
       {RadiusMeasure::circle, RadiusMeasure::mean, RadiusMeasure::maximum, RadiusMeasure::hull})
    measure_->addItem(nameOf(measure), static_cast<int>(measure));
  opensOnEnter(*measure_);
  measure_->setObjectName("section_measure");
  measure_->setAccessibleName(tr("Measured by"));
  measure_->setToolTip(tr("What the dashed circle is taken from"));
  measure_->setMinimumWidth(72);
  measure_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  apply_->setObjectName("apply_section");
  apply_->setToolTip(tr("Gives the node the center and the radius of the dashed circle"));
  words_->setObjectName("section_words");
  words_->setWordWrap(true);
  words_->setProperty("role", "quiet");
  words_->setMinimumWidth(72);
  words_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  view_->setToolTip(tr("Drag the center or the rim. Wheel: zoom. Double click: show all"));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(measure_, 1);
  row->addWidget(apply_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(title);
  column->addWidget(view_);
  column->addLayout(row);
  column->addWidget(words_);
}

void CrossSectionPanel::setEditable(bool isEditable) {
  isEditable_ = isEditable;
  refreshEditable();
}

std::vector<Eigen::Vector3d> CrossSectionPanel::ring() const {
  if (!node_ || !view_->section() || !(isPointerInside_ || view_->isBusy())) return {};
  const SectionNode& node = view_->node();
  if (node.radius == 0) return {};
  constexpr int corners = 64;
  std::vector<Eigen::Vector3d> ring;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back(view_->section()->place(
        node.center + node.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  return ring;
}

void CrossSectionPanel::refresh() {
  const std::vector<NodeId>& chosen = document_.selection().nodes();
  std::optional<NodeId> node;
  if (chosen.size() == 1 && document_.scan() && document_.skeleton().contains(chosen.front()))
    node = chosen.front();
  const bool isSame = node && node == node_;
  node_ = node;
  setVisible(node.has_value());
  if (!node) {
    view_->setSection(std::nullopt);
    emit ringChanged();
    return;
  }
  if (isSame && (view_->isBusy() || isOwnEdit_))
    showNode(); // in the section that the drag began in: its points are to stay under the pointer
  else
    showSection(isSame && view_->isZoomed() && view_->section() &&
                view_->section()->center == document_.skeleton()[*node].position);
}

/// Takes the section at the node anew.
void CrossSectionPanel::showSection(bool keepView) {
  const Scan& scan = *document_.scan();
  const CrossSections sections(
      document_.skeleton(),
      {scan.cloud()->positions(), scan.cloud()->origin(), scan.index(), scan.spacing()});
  view_->setUnit(document_.unit());
  view_->setSection(sections.at(*node_), keepView);
  showNode();
  showProposed();
}

void CrossSectionPanel::showNode() {
  const Node& node = document_.skeleton()[*node_];
  SectionNode shown{.center = Eigen::Vector2d::Zero(), .radius = node.radius};
  if (const std::optional<CrossSection>& section = view_->section()) {
    const Eigen::Vector3d d = node.position - section->center;
    shown.center = {d.dot(section->right), d.dot(section->up)};
  }
  view_->setNode(shown);
  emit ringChanged();
}

void CrossSectionPanel::showProposed() {
  proposed_.reset();
  if (!node_) return;
  const MeasuredCircle found = view_->section() ? measuredCircle(*view_->section(), measure())
                                                : MeasuredCircle(NoRadius::noSection);
  if (const auto* circle = std::get_if<FittedCircle>(&found)) {
    proposed_ = *circle;
    words_->setText(describe(*circle));
  } else {
    words_->setText(describe(std::get<NoRadius>(found)));
  }
  view_->setProposed(proposed_);
  view_->setAccessibleDescription(
      tr("Radius %1. %2")
          .arg(formatLength(view_->node().radius, document_.unit()), words_->text()));
  refreshEditable();
}

void CrossSectionPanel::refreshEditable() {
  const bool canEdit = isEditable_ && !document_.isReadOnly();
  view_->setEditable(canEdit);
  apply_->setEnabled(canEdit && proposed_);
}

void CrossSectionPanel::ask(const SectionNode& node, Gesture gesture) {
  const CrossSection& section = *view_->section();
  const Eigen::Vector3d place = section.place(node.center);
  const bool isMoved = node.center != view_->node().center;
  const QString name = isMoved ? tr("Center node %1") : tr("Set the radius of node %1");
  const auto change = [&](SkeletonEditor& editor) {
    if (isMoved) moveNode(editor, *node_, place);
    editor.setRadius(*node_, node.radius);
  };
  isOwnEdit_ = true;
  emit edited(name.arg(indexOf(*node_)), change, gesture);
  isOwnEdit_ = false;
}

void CrossSectionPanel::apply() {
  if (!apply_->isEnabled() || !proposed_) return;
  ask({.center = proposed_->center, .radius = proposed_->radius}, Gesture::begin());
  if (node_) showSection(true);
}

RadiusMeasure CrossSectionPanel::measure() const {
  return static_cast<RadiusMeasure>(measure_->currentData().toInt());
}

QString CrossSectionPanel::describe(const FittedCircle& circle) const {
  const double error = circle.error / circle.radius;
  constexpr double clean = 0.05; // of the radius
  constexpr double rough = 0.15;
  constexpr double around = 0.9; // of the circle
  const QString quality = error <= clean ? tr("clean") : error <= rough ? tr("rough") : tr("poor");
  const QString cover =
      circle.coverage >= around ? tr("points all around (%1)") : tr("points on %1 of the circle");
  return tr("%1, %2; error %3 (%4): %5")
      .arg(formatLength(circle.radius, document_.unit()), cover.arg(percent(circle.coverage)),
           formatLength(circle.error, document_.unit(), 2), percent(error), quality);
}

QString CrossSectionPanel::describe(NoRadius reason) const {
  const QString name = nameOf(measure()).toLower();
  const std::size_t count = view_->section() ? view_->section()->points.size() : 0;
  switch (reason) {
  case NoRadius::noSection:
    return tr("No section: the node has no neighbor that gives it a direction.");
  case NoRadius::fewPoints:
    return tr("No %1: too few points here (%2).").arg(name, formatCount(count));
  case NoRadius::oneSided:
    return tr("No %1: the points cover less than %2 of the circle.")
        .arg(name, percent(leastCoverage(measure())));
  case NoRadius::noCircle:
    break;
  }
  return tr("No %1: the points lie about no circle.").arg(name);
}

} // namespace espalier
