#pragma once

#include <QObject>

namespace espalier {

class PlantDocument;
class PlantView;

/// Keeps the 3D view what the document is. Nothing flows the other way.
class ViewSync : public QObject {
  Q_OBJECT

public:
  ViewSync(PlantDocument& document, PlantView& view, QObject* parent = nullptr);
};

/// Moves the camera so that the chosen nodes fill the view; all of the plant if none is chosen.
void frameSelection(PlantDocument& document, PlantView& view);

} // namespace espalier
