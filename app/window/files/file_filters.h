#pragma once

#include "core/io/formats.h"
#include "core/mtg/mtg_of_skeleton.h"

#include <QString>
#include <QStringList>

class QFileDialog;

namespace espalier {

class PlantDocument;

/// Of the settings: the folder of the last file that was chosen.
inline const QString folderKey = QStringLiteral("last_folder");

// The kinds of files that dialogs list, as "MTG structure (*.mtg)".

/// All that can be opened, in one text.
[[nodiscard]] QString readableFilters();

/// All that has points, or a structure, and is no project, in one text.
[[nodiscard]] QString filtersOf(Content content);

/// All that has a skeleton, projects too, in one text.
[[nodiscard]] QString structureFilters();

/// All that a skeleton can be written as. An MTG of one without scales of its own can be of either
/// style, each a kind of its own.
[[nodiscard]] QStringList writableFilters(bool hasScales);

/// All that points can be written as.
[[nodiscard]] QStringList writablePointFilters();

/// That of an MTG of a structure without scales of its own.
[[nodiscard]] QString filterOf(MtgStyle style);

/// The first of the kinds that a file of this name can be of; the first of all if none fits.
[[nodiscard]] QString filterFor(const QString& path, const QStringList& filters);

/// The format of the kind that was chosen, if a file of this name can be of it; else that of the
/// name. @throws Error as formatToWrite
[[nodiscard]] const Format& formatChosen(const QString& filter, const QString& path);

/// A file name with an extension of this kind of file: its own if it has one.
/// @param before  the kind it was of, whose extension goes as a whole: ".lines.obj"
[[nodiscard]] QString withExtensionOf(const QString& filter, const QString& path,
                                      const QString& before);

/// Proposes a file beside that of the plant, or else beside its scan, with the name of that.
/// @param ending  ".report.html"
void proposeBeside(QFileDialog& dialog, const PlantDocument& document, const QString& ending);

} // namespace espalier
