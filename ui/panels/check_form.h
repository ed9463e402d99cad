#pragma once

#include "core/base/rule.h"
#include "core/skeleton/check_options.h"

#include <QString>
#include <QWidget>

#include <map>
#include <string>
#include <vector>

class QScrollArea;
class QToolButton;

namespace espalier {

class OptionField;

/// From where on the checks report something: a form of core/pipeline/check_table.h, folded up at
/// first.
class CheckForm : public QWidget {
  Q_OBJECT

public:
  explicit CheckForm(QWidget* parent = nullptr);

  [[nodiscard]] CheckOptions options() const;
  /// What the user has set, by the names of the options.
  [[nodiscard]] std::map<std::string, double> chosen() const;
  /// Shows these, and the defaults of the others; emits nothing. Unknown names are passed over.
  void choose(const std::map<std::string, double>& chosen);

  void setOpen(bool isOpen);
  [[nodiscard]] bool isOpen() const;

signals:
  void opened(bool isOpen);
  void changed();

private:
  void refreshHeader();

  QToolButton* header_;
  QScrollArea* body_;
  std::vector<OptionField*> fields_; // in the order of the table
};

} // namespace espalier
