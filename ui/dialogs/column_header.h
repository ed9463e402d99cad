#pragma once

#include "core/io/points/point_field.h"

#include <QHeaderView>

#include <vector>

class QComboBox;

namespace espalier {

/// The header of a table of a text file: above each column stands a list of what it may hold.
class ColumnHeader : public QHeaderView {
  Q_OBJECT

public:
  explicit ColumnHeader(const std::vector<PointField>& chosen, QWidget* parent = nullptr);

  [[nodiscard]] std::vector<PointField> fields() const; // as chosen
  [[nodiscard]] const std::vector<QComboBox*>& lists() const { return lists_; }
  [[nodiscard]] QSize sizeHint() const override;

signals:
  void fieldsChanged();

protected:
  void updateGeometries() override;
  [[nodiscard]] QSize sectionSizeFromContents(int column) const override;
  void paintSection(QPainter* /*painter*/, const QRect& /*rect*/, int /*column*/) const override {}

private:
  void place();

  std::vector<QComboBox*> lists_; // by column
};

/// What a column holds, as users read it.
[[nodiscard]] QString textOf(PointField field);

} // namespace espalier
