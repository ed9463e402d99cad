#pragma once

#include <QKeySequence>
#include <QLineEdit>

namespace espalier {

/// A field that takes the keys pressed in it, one combination, at once. Tab moves on, as anywhere.
class KeyEdit : public QLineEdit {
  Q_OBJECT

public:
  explicit KeyEdit(QWidget* parent = nullptr);

  [[nodiscard]] const QKeySequence& keys() const { return keys_; }
  void setKeys(const QKeySequence& keys);

signals:
  void keysChanged(const QKeySequence& keys);

protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  QKeySequence keys_;
};

} // namespace espalier
