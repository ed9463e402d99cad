#include "app/window/files/scan_question.h"

#include "app/window/files/load_files.h"
#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/io/glance.h"

#include <QCoreApplication>

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

bool showsItself(const Format& format) {
  return format.glance != nullptr || format.glanceByColumns != nullptr;
}

} // namespace

QString columnsKey(const FirstLines& text) {
  if (!text.names.empty()) return QString::fromStdString(text.names);
  if (text.doubt == ColumnDoubt::none) return {};
  return QStringLiteral("%1/%2").arg(text.columns.size()).arg(static_cast<int>(text.doubt));
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
    look.columns = known.value(columnsKey(*look.text));
    if (look.columns.size() != look.text->columns.size()) look.columns.clear();
  }
  look.glance = glanceAt(toPath(*path), look.columns);
  return look;
}

} // namespace espalier
