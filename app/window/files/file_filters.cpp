#include "app/window/files/file_filters.h"

#include "app/window/files/file_flow.h"
#include "ui/document/plant_document.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>

namespace espalier {
namespace {

QString patternsOf(const Format& format) {
  QStringList patterns;
  for (const std::string_view extension : format.extensions)
    patterns.append("*." + QString::fromUtf8(extension.data(), qsizetype(extension.size())));
  return patterns.join(' ');
}

QString filterOf(const Format& format) {
  return QString::fromUtf8(format.description.data(), qsizetype(format.description.size())) + " (" +
         patternsOf(format) + ")";
}

/// ".mtg" and its like, the usual one first.
QStringList extensionsIn(const QString& filter) {
  static const QRegularExpression pattern(R"(\*(\.[\w.]+))");
  QStringList extensions;
  for (const QRegularExpressionMatch& match : pattern.globalMatch(filter))
    extensions.append(match.captured(1));
  return extensions;
}

/// The longest extension that a name ends with: "a.lines.obj" is lines, not a surface.
QString extensionOf(const QString& path, const QStringList& filters) {
  QString longest;
  for (const QString& filter : filters)
    for (const QString& extension : extensionsIn(filter))
      if (path.endsWith(extension, Qt::CaseInsensitive) && extension.size() > longest.size())
        longest = extension;
  return longest;
}

} // namespace

QString readableFilters() {
  QStringList filters;
  QStringList all;
  for (const Format& format : formats()) {
    if (!format.canRead() && format.canWrite()) continue; // made for other programs
    all.append(patternsOf(format));
    filters.append(filterOf(format));
  }
  filters.prepend(FileFlow::tr("Projects (*.espalier)"));
  all.append("*.espalier");
  filters.prepend(FileFlow::tr("Projects, scans and skeletons (%1)").arg(all.join(' ')));
  filters.append(FileFlow::tr("All files (*)"));
  return filters.join(";;");
}

QString filtersOf(Content content) {
  QStringList all;
  for (const Format& format : formats())
    if (format.content == content && format.canRead()) all.append(patternsOf(format));
  const QString name =
      content == Content::points ? FileFlow::tr("Scans (%1)") : FileFlow::tr("Skeletons (%1)");
  return name.arg(all.join(' ')) + ";;" + FileFlow::tr("All files (*)");
}

QString structureFilters() {
  QStringList all;
  for (const Format& format : formats())
    if (format.content == Content::structure && format.canRead()) all.append(patternsOf(format));
  all.append("*.espalier");
  return FileFlow::tr("Skeletons and projects (%1)").arg(all.join(' ')) + ";;" +
         FileFlow::tr("All files (*)");
}

QStringList writableFilters(bool hasScales) {
  QStringList filters;
  for (const Format& format : formats()) {
    if (format.writeStructure == nullptr) continue;
    if (!hasScales && format.name == "MTG")
      filters.append({filterOf(MtgStyle::plantNode), filterOf(MtgStyle::plantAxisNode)});
    else
      filters.append(filterOf(format));
  }
  return filters;
}

QStringList writablePointFilters() {
  QStringList filters;
  for (const Format& format : formats())
    if (format.writePoints != nullptr) filters.append(filterOf(format));
  return filters;
}

QString filterOf(MtgStyle style) {
  return style == MtgStyle::plantAxisNode
             ? FileFlow::tr("MTG of plant, axes and nodes (*.mtg)")
             : FileFlow::tr("MTG of plant and nodes, as PlantScan3D writes (*.mtg)");
}

const Format& formatChosen(const QString& filter, const QString& path) {
  for (const Format& format : formats()) {
    const bool isMtg = format.name == "MTG" && (filter == filterOf(MtgStyle::plantNode) ||
                                                filter == filterOf(MtgStyle::plantAxisNode));
    if (format.writeStructure == nullptr || !(isMtg || filter == filterOf(format))) continue;
    if (extensionsIn(filter).contains(extensionOf(path, writableFilters(true)))) return format;
  }
  return formatToWrite(toPath(path), Content::structure);
}

QString filterFor(const QString& path, const QStringList& filters) {
  const QString extension = extensionOf(path, filters);
  const auto found = std::ranges::find_if(
      filters, [&](const QString& filter) { return extensionsIn(filter).contains(extension); });
  return found == filters.end() ? filters.value(0) : *found;
}

QString withExtensionOf(const QString& filter, const QString& path, const QString& before) {
  const QStringList wanted = extensionsIn(filter);
  const QString extension = extensionOf(path, writableFilters(true));
  if (path.isEmpty() || wanted.isEmpty()) return path;
  QString stem = path.left(path.size() - extension.size());
  const QString last = extensionsIn(before).value(0); // Qt changes no more than what is after a dot
  const QString rest = last.left(last.lastIndexOf('.'));
  if (!rest.isEmpty() && stem.endsWith(rest)) stem.chop(rest.size());
  return stem + (wanted.contains(extension) ? extension : wanted.front());
}

void proposeBeside(QFileDialog& dialog, const PlantDocument& document, const QString& ending) {
  const QString path = document.filePath().isEmpty() ? document.scanPath() : document.filePath();
  if (path.isEmpty()) return dialog.selectFile(FileFlow::tr("plant") + ending);
  dialog.setDirectory(QFileInfo(path).absolutePath());
  dialog.selectFile(QFileInfo(path).completeBaseName() + ending);
}

} // namespace espalier
