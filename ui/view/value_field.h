#pragma once

#include <QLineEdit>

namespace espalier {

/// A field over the view for one number. Enter takes it, Tab takes it and goes on, Escape does not;
/// then it goes away, and the view has the keyboard again.
class ValueField : public QLineEdit {
  Q_OBJECT

public:
  ValueField(const QString& text, QWidget* view);
  void open();

signals:
  void typed(const QString& text, bool goesOn);

protected:
  bool event(QEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

private:
  void close(bool takes, bool goesOn);

  bool isOpen_ = false;
};

} // namespace espalier
