#pragma once

#include "app/window/frame/window_part.h"
#include "core/pipeline/pipeline.h"

#include <QString>

#include <iosfwd>
#include <string>
#include <vector>

class QMenu;
class QSettings;
class QWidget;

namespace espalier {

class ActionSet;
class PipelinePanel;
class PlantDocument;

/// The settings of all steps as a whole: those that come with the program, those that the user
/// keeps under a name, and files of them.
class PresetFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PipelinePanel& pipeline;
    ActionSet& actions;
    QSettings& settings;
    QWidget& window;
    const PlantDocument& document; // whose unit lengths as "38 mm" are turned into
  };
  explicit PresetFlow(const Parts& parts);

signals:
  void chosen(); // other settings are shown

private:
  void fill(QMenu& menu); // anew: what is kept may have changed
  struct Own {
    QString name;
    std::string text; // as a file of settings
  };
  [[nodiscard]] std::vector<Own> own() const;
  void setOwn(const std::vector<Own>& all);
  void keep();
  void forget(const QString& name);
  void take(const PipelineOptions& options, const QString& name); // what it replaces is offered
  void show(const PipelineOptions& options);
  void open();
  void save();
  void write(std::ostream& out) const; // with that unit

  Parts parts_;
};

} // namespace espalier
