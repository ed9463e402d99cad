#pragma once

#include "core/pipeline/envelopes.h"

#include <QString>
#include <QWidget>

#include <map>
#include <string>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace espalier {

class MethodForm;

/// Which envelope is drawn about the crown.
struct EnvelopeChoice {
  const EnvelopeKind* kind = nullptr;       // null: none
  bool isOfSkeleton = false;                // about its nodes, not about the points
  std::map<std::string, Rule> options = {}; // that were set, by name

  /// As envelopeValues() takes them. pre: there is a kind
  [[nodiscard]] std::vector<std::string> settings() const;
  bool operator==(const EnvelopeChoice&) const = default;
};

/// The envelope about the crown: what it is, with the options of its kind, and its numbers.
class EnvelopePanel : public QWidget {
  Q_OBJECT

public:
  struct Number {
    QString label;
    QString text;
    QString help = {};
  };

  explicit EnvelopePanel(QAction& write, QWidget* parent = nullptr);

  [[nodiscard]] EnvelopeChoice choice() const;
  void setChoice(const EnvelopeChoice& choice); // notifies nobody
  void setScale(const PlantScale& scale, const QString& unit);
  void setHasPoints(bool hasPoints); // else it is about the skeleton, whatever is chosen

  /// @param handles  what it says of the handles
  void showNumbers(const std::vector<Number>& numbers, const QString& handles, bool isByHand);
  void showWords(const QString& words);   // in place of numbers: what to do, or why there are none
  void setStale(bool isStale);            // it is being drawn anew
  void showDrawing(const QString& words); // likewise, beside the numbers of before

signals:
  void changed();      // the choice
  void fitRequested(); // as nothing was dragged

private:
  void makeForm();
  void makeNumbers(const std::vector<Number>& numbers);
  void refresh();

  QComboBox* kind_;
  QComboBox* about_;
  QWidget* body_;
  QVBoxLayout* formPlace_;
  MethodForm* form_ = nullptr;  // of the kind; null: none
  QWidget* numbers_ = nullptr;  // null: none are shown
  std::vector<QLabel*> values_; // of them
  QVBoxLayout* numbersPlace_;
  QLabel* words_;
  QLabel* handles_;
  QPushButton* fit_;
  QWidget* write_;
  PlantScale scale_{.spacing = 1, .height = 100};
  QString unit_;
};

} // namespace espalier
