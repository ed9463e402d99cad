#include "ui/document/shown_message.h"

#include "ui/document/shown_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

namespace espalier {
namespace {

struct PlaceText {
  Q_DECLARE_TR_FUNCTIONS(FilePlace)
};

/// "oak.mtg, line 12, column 3": in a window, one knows where the file is.
QString placeText(const FilePlace& place) {
  const QFileInfo file(QString::fromStdString(place.file));
  QStringList parts = {file.isDir() ? file.filePath() : file.fileName()};
  if (place.line) parts.append(PlaceText::tr("line %1").arg(*place.line));
  if (place.column) parts.append(PlaceText::tr("column %1").arg(*place.column));
  if (place.byte) parts.append(PlaceText::tr("byte %1").arg(*place.byte));
  return parts.join(QStringLiteral(", "));
}

} // namespace

QString shownText(const ShownMessage& message) {
  const bool isAsItIs = message.sentence == "%1"; // a text that is in the language already
  const std::string sentence =
      isAsItIs ? message.sentence : shownText(message.sentence).toStdString();
  const QString text = QString::fromStdString(inEnglish(ShownMessage{sentence, message.values}));
  return message.where ? PlaceText::tr("%1: %2").arg(placeText(*message.where), text) : text;
}

QString shownText(const std::exception& error) {
  return shownText(messageOf(error));
}

} // namespace espalier
