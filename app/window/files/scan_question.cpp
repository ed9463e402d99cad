#include "app/window/files/scan_question.h"

#include "app/window/files/load_files.h"
#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/io/glance.h"
#include "ui/document/shown_message.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>

#include <string>
#include <string_view>

namespace espalier {
namespace {

/// The path of the one scan among files; none: there is none, or there are several.
std::optional<QString> onlyScan(const QStringList& paths) {
  std::optional<QString> scan;
  for (const QString& path : paths) {
    if (formatOf(toPath(path)).content != Content::points) continue;
    if (scan) return std::nullopt;
    scan = path;
  }
  return scan;
}

const char* const namedKey = "files/named_columns";

QString textOf(const std::vector<PointField>& columns) {
  QStringList names;
  for (const PointField column : columns) {
    const std::string_view name = nameOf(column);
    names.append(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
  }
  return names.join(' ');
}

std::vector<PointField> columnsIn(const QString& text) {
  std::vector<PointField> columns;
  for (const QString& name : text.split(' ', Qt::SkipEmptyParts))
    columns.push_back(pointFieldNamed(name.toStdString()));
  return columns;
}

bool showsItself(const Format& format) {
  return format.glance != nullptr || format.glanceByColumns != nullptr;
}

} // namespace

QString columnsKey(const FirstLines& text) {
  if (!text.names.empty()) return QString::fromStdString(text.names);
  if (text.doubt == ColumnDoubt::none) return {};
  return QStringLiteral("%1/%2").arg(text.columns.size()).arg(static_cast<int>(text.doubt));
}

NamedColumns namedColumns(const QSettings& settings) {
  NamedColumns named;
  const QJsonObject kept =
      QJsonDocument::fromJson(settings.value(namedKey).toString().toUtf8()).object();
  for (auto it = kept.begin(); it != kept.end(); ++it)
    named[it.key()] = columnsIn(it.value().toString());
  return named;
}

void keepNamedColumns(QSettings& settings, const NamedColumns& named) {
  QJsonObject kept;
  for (auto it = named.begin(); it != named.end(); ++it)
    kept[it.key()] = textOf(it.value());
  settings.setValue(namedKey,
                    QString::fromUtf8(QJsonDocument(kept).toJson(QJsonDocument::Compact)));
}

std::optional<ScanLook> lookAtScan(const QStringList& paths, Asking asking,
                                   const NamedColumns& known) {
  const std::optional<QString> path = onlyScan(paths);
  if (!path || asking == Asking::never) return std::nullopt;
  const Format& format = formatOf(toPath(*path));
  if (asking == Asking::ifUnclear && !showsItself(format)) return std::nullopt;
  const QString name = QString::fromUtf8(format.name.data(), qsizetype(format.name.size()));
  ScanLook look{.path = *path, .format = name, .glance = {}, .text = firstLinesAt(toPath(*path))};
  if (look.text) {
    look.alike = columnsKey(*look.text);
    look.columns = known.value(look.alike);
    if (look.columns.size() != look.text->columns.size()) look.columns.clear();
  }
  try {
    look.glance = glanceAt(toPath(*path), look.columns);
  } catch (const Error& error) {
    if (!look.text || look.text->columns.empty()) throw;
    look.failure = shownText(error);
  }
  return look;
}

} // namespace espalier
