#pragma once

#include "core/evaluate/compartments.h"
#include "core/evaluate/trait_rows.h"

#include <QList>
#include <QWidget>

class QAction;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QScrollArea;

namespace espalier {

class PlantDocument;

/// The traits of the plant by itself, in the place of scores while there is no reference: sizes,
/// stem, crown, angles, wood, light, the axes of each order, and length, volume and biomass of
/// organs by class.
class TraitsPanel : public QWidget {
  Q_OBJECT

public:
  /// What its buttons do.
  struct Parts {
    QAction* load;   // a reference
    QAction* beside; // loads that which lies beside the scan; hidden: there is none
    QAction* light;  // measures it
    QAction* report; // writes all of it to a file
  };
  TraitsPanel(const PlantDocument& document, const Parts& parts, QWidget* parent = nullptr);

  /// @param isLightStale whether its light is of the plant before it was changed
  void show(const PlantMeasures& measures, bool isLightStale);
  void forget(const QString& why = {}); // there is no plant to measure, or why it cannot be
  void setStale(bool isStale);          // the plant has changed since

  // Of wood [kg/m³]; 0: not known.
  static constexpr double leastDensity = 1;
  static constexpr double mostDensity = 2000;
  void setDensity(double density); // notifies nobody

signals:
  void densityChosen(double density);

private:
  QWidget* makeHead(const Parts& parts);
  QWidget* makePage(const PlantMeasures& measures, bool isLightStale);
  QWidget* makeGroup(const QString& name, const std::vector<TraitRow>& rows);
  QWidget* makeAxes(const Traits& traits);
  QWidget* makeCompartments(const CompartmentTable& table, bool hasBiomass);
  [[nodiscard]] QString nameOf(const Compartment& row) const;
  QLabel* makeValue(const QString& name, const QString& text, const QString& help);

  const PlantDocument& document_;
  QLabel* title_;
  QDoubleSpinBox* density_;
  QLabel* hint_;
  QLabel* warnings_;
  QScrollArea* area_;
  QList<QLabel*> values_; // of the page that is shown
};

} // namespace espalier
