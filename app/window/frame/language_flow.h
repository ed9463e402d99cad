#pragma once

#include "app/window/frame/window_part.h"

class QSettings;

namespace espalier {

class ActionSet;

/// The choice of the language of the window, which is used when the program starts anew.
class LanguageFlow : public WindowPart {
  Q_OBJECT

public:
  LanguageFlow(ActionSet& actions, QSettings& settings);

private:
  void choose(const QString& language);

  QSettings& settings_;
};

} // namespace espalier
