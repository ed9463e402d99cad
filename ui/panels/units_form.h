#pragma once

#include "core/mtg/mtg.h"
#include "core/skeleton/skeleton_delta.h"

#include <QList>
#include <QStringList>
#include <QWidget>

#include <functional>

class QCheckBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace espalier {

class PlantDocument;

/// What an MTG says of a node and of the units it belongs to, finest first: class, index, features.
/// What is typed is told as an edit, which the window makes: a wrong text is refused by it.
class UnitsForm : public QWidget {
  Q_OBJECT

public:
  explicit UnitsForm(PlantDocument& document, QWidget* parent = nullptr);

  void show(NodeId id); // and hides itself if the skeleton carries nothing of an MTG
  void showNothing();

signals:
  /// @param name   of the undo step
  /// @param field  where it was typed
  void typed(const QString& name, const std::function<void(espalier::SkeletonEditor&)>& change,
             QWidget* field);
  void leaveRequested(); // what was typed is taken: the keys are the plant's again

private:
  struct Row {  // a line of the form
    QString id; // of its field: "class_2"
    QString label;
    QString text;
    QString help;
    QString step;                                                    // name of the undo step
    std::function<void(SkeletonEditor&, const std::string&)> change; // to what is typed
  };
  struct Part { // an entity
    QString id;
    QString title;
    QList<Row> rows;
    bool canBegin = false; // a unit that begins here or before
    bool begins = false;
    QString step;
    std::function<void(SkeletonEditor&)> beginOrEnd;
  };
  [[nodiscard]] QList<Part> partsOf(NodeId id) const;
  [[nodiscard]] Part partOf(NodeId start, const Entity& entity, bool isNode) const;
  void build(const QList<Part>& parts);
  void makeFields();
  void beginOrEnd(QCheckBox& begins);
  void addRow(const Row& row, QFormLayout& to);
  bool take(QLineEdit& field);

  PlantDocument& document_;
  QVBoxLayout* column_;
  QWidget* body_ = nullptr;
  int shown_ = 0;     // how often
  QStringList shape_; // the ids of what is shown
  QList<Part> parts_;
};

} // namespace espalier
