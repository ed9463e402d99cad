#include "ui/document/shown_message.h"

#include "ui/document/shown_text.h"

namespace espalier {

QString shownText(const ShownMessage& message) {
  const std::string sentence = shownText(message.sentence).toStdString();
  return QString::fromStdString(inEnglish(ShownMessage{sentence, message.values}));
}

QString shownText(const std::exception& error) {
  const auto* shown = dynamic_cast<const ShownError*>(&error);
  return shown != nullptr ? shownText(shown->message()) : QString::fromUtf8(error.what());
}

} // namespace espalier
