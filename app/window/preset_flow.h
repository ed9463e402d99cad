#pragma once

#include <QObject>

class QMenu;
class QSettings;
class QWidget;

namespace espalier {

class ActionSet;
class MessageBanner;
class PipelinePanel;

/// The settings of all steps as a whole: those that come with the program, and files of them.
class PresetFlow : public QObject {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PipelinePanel& pipeline;
    ActionSet& actions;
    MessageBanner& banner;
    QSettings& settings;
    QWidget& window;
  };
  explicit PresetFlow(const Parts& parts);

  void fillMenu(QMenu& menu) const;

signals:
  void chosen(); // other settings are shown

private:
  void open();
  void save();

  Parts parts_;
};

} // namespace espalier
