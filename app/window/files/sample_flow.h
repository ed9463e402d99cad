#pragma once

#include "app/window/frame/window_part.h"

#include <QString>

class QSettings;

namespace espalier {

class ActionSet;
class JobSlot;

/// A plant to try the program on: a tree that is grown and scanned by the simulator, so that its
/// true structure is known. Its files are made once, and kept with what the program keeps.
class SampleFlow : public WindowPart {
  Q_OBJECT

public:
  /// The files are sample_tree.ply and sample_tree.mtg, its true structure, in the folder that
  /// `settings` name, else where the program keeps its own.
  SampleFlow(ActionSet& actions, JobSlot& jobs, const QSettings& settings);

signals:
  void made(const QString& scan); // is there, to be opened

private:
  void make();

  JobSlot& jobs_;
  QString folder_;
};

} // namespace espalier
