#include "ui/dialogs/column_header.h"

#include <QComboBox>
#include <QScrollBar>

#include <array>

namespace espalier {
namespace {

constexpr std::array choosable = {PointField::x,         PointField::y,       PointField::z,
                                  PointField::intensity, PointField::red,     PointField::green,
                                  PointField::blue,      PointField::station, PointField::none};
constexpr int gap = 2; // between lists

} // namespace

QString textOf(PointField field) {
  switch (field) {
  case PointField::x:
    return QStringLiteral("x");
  case PointField::y:
    return QStringLiteral("y");
  case PointField::z:
    return QStringLiteral("z");
  case PointField::intensity:
    return ColumnHeader::tr("intensity");
  case PointField::red:
    return ColumnHeader::tr("red");
  case PointField::green:
    return ColumnHeader::tr("green");
  case PointField::blue:
    return ColumnHeader::tr("blue");
  case PointField::station:
    return ColumnHeader::tr("station");
  case PointField::none:
  case PointField::packedColor: // texts have none
    break;
  }
  return ColumnHeader::tr("left out");
}

ColumnHeader::ColumnHeader(const std::vector<PointField>& chosen, QWidget* parent)
    : QHeaderView(Qt::Horizontal, parent) {
  setSectionResizeMode(QHeaderView::ResizeToContents);
  for (std::size_t column = 0; column < chosen.size(); ++column) {
    auto* list = new QComboBox(viewport());
    for (const PointField field : choosable)
      list->addItem(textOf(field), static_cast<int>(field));
    list->setCurrentIndex(list->findData(static_cast<int>(chosen[column])));
    list->setObjectName(QStringLiteral("column_%1").arg(column + 1));
    list->setAccessibleName(tr("Column %1 holds").arg(column + 1));
    list->setToolTip(tr("What column %1 of the file holds").arg(column + 1));
    connect(list, &QComboBox::currentIndexChanged, this, &ColumnHeader::fieldsChanged);
    lists_.push_back(list);
  }
  connect(this, &QHeaderView::sectionResized, this, &ColumnHeader::place);
}

std::vector<PointField> ColumnHeader::fields() const {
  std::vector<PointField> fields;
  for (const QComboBox* list : lists_)
    fields.push_back(static_cast<PointField>(list->currentData().toInt()));
  return fields;
}

QSize ColumnHeader::sizeHint() const {
  const QSize size = QHeaderView::sizeHint();
  return {size.width(), lists_.empty() ? size.height() : lists_.front()->sizeHint().height() + gap};
}

void ColumnHeader::updateGeometries() {
  QHeaderView::updateGeometries();
  place();
}

QSize ColumnHeader::sectionSizeFromContents(int column) const {
  const auto at = static_cast<std::size_t>(column);
  return at < lists_.size() ? lists_[at]->sizeHint() + QSize(gap, gap)
                            : QHeaderView::sectionSizeFromContents(column);
}

void ColumnHeader::place() {
  for (int column = 0; column < count(); ++column)
    lists_[static_cast<std::size_t>(column)]->setGeometry(
        sectionViewportPosition(column), 0, sectionSize(column) - gap, height() - gap);
}

} // namespace espalier
