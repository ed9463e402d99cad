#pragma once

#include "core/mtg/mtg.h"
#include "core/skeleton/skeleton_delta.h"

#include <QList>
#include <QString>

#include <functional>

namespace espalier {

class PlantDocument;

/// A line of the form about nodes and units.
struct UnitRow {
  QString id; // of its field: "class_2"
  QString label;
  QString text;
  QString help;
  QString step;                                                    // name of the undo step
  std::function<void(SkeletonEditor&, const std::string&)> change; // to what is typed
  QString heading = {};                                            // above it: of a later date
};

/// The lines of one entity: a node, or a unit it belongs to.
struct UnitPart {
  QString id; // "unit_2", by its scale
  QString title;
  NodeId start{}; // the node that carries it
  int scale = 1;
  QString name; // in the names of undo steps
  QList<UnitRow> rows;
  bool canDate = false;  // there are features that a later date can have values of
  bool canBegin = false; // a unit that begins here or before
  bool begins = false;
  QString step = {}; // of beginning or ending it
  std::function<void(SkeletonEditor&)> beginOrEnd = {};
};

/// What an MTG says of a node and of the units it belongs to, finest first. Of a plant
/// without any, the node alone, to which features can be added.
[[nodiscard]] QList<UnitPart> unitParts(const PlantDocument& document, NodeId id);

/// The MTG that the skeleton is a view of; null if it was made here.
[[nodiscard]] const Mtg* baseOf(const PlantDocument& document);

} // namespace espalier
