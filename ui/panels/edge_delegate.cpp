#include "ui/panels/edge_delegate.h"

#include <QComboBox>

namespace espalier {

QWidget* EdgeDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                                    const QModelIndex& /*index*/) const {
  auto* types = new QComboBox(parent);
  types->setAccessibleName(tr("Type of the edge"));
  types->addItem(tr("< continues the axis"), QStringLiteral("<"));
  types->addItem(tr("+ begins an axis"), QStringLiteral("+"));
  types->setMinimumWidth(types->sizeHint().width());
  auto* self = const_cast<EdgeDelegate*>(this); // as Qt's signals ask for
  connect(types, &QComboBox::activated, self, [self, types] {
    emit self->commitData(types);
    emit self->closeEditor(types);
  });
  return types;
}

void EdgeDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  auto* types = static_cast<QComboBox*>(editor);
  types->setCurrentIndex(types->findData(index.data(Qt::EditRole)));
}

void EdgeDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                const QModelIndex& index) const {
  const QString type = static_cast<QComboBox*>(editor)->currentData().toString();
  if (type != index.data(Qt::EditRole).toString()) model->setData(index, type, Qt::EditRole);
}

} // namespace espalier
