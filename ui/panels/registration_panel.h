#pragma once

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QAction;
class QCheckBox;
class QLabel;
class QTableWidget;

namespace espalier {

class NumberBox;

/// How another scan is laid on the open one: the pairs of targets with what each is off, and what
/// follows. It asks for what is to be clicked next.
class RegistrationPanel : public QWidget {
  Q_OBJECT

public:
  struct Actions {
    QAction& begin;
    QAction& fit;
    QAction& color;
    QAction& join;
    QAction& moveStructure;
    QAction& reset;
    QAction& leave;
  };
  explicit RegistrationPanel(const Actions& actions, QWidget* parent = nullptr);

  struct Pair {
    QString residual; // empty: not known yet
    bool isWorst = false;
  };
  struct Shown {
    QString next; // what is to be clicked
    std::vector<Pair> pairs;
    QString byPairs;  // how well they fit; empty: not known
    QString byPoints; // likewise
    QString warning;  // empty: none
  };
  void show(const std::optional<Shown>& shown); // none: nothing is registered

  /// Are targets spheres, whose middle is found from the points about a click?
  [[nodiscard]] bool areSpheres() const;
  [[nodiscard]] std::optional<double> sphereRadius() const; // [L]; none: it is found
  void setUnit(const QString& unit);

signals:
  void removeRequested(int pair);

private:
  void fillTable(const std::vector<Pair>& pairs);

  QWidget* empty_;
  QWidget* work_;
  QLabel* next_;
  QCheckBox* spheres_;
  NumberBox* radius_;
  QTableWidget* table_;
  QLabel* byPairs_;
  QLabel* byPoints_;
  QLabel* warning_;
};

} // namespace espalier
