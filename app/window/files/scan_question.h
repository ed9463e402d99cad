#pragma once

#include "ui/dialogs/scan_look.h"

#include <QHash>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <vector>

class QSettings;

namespace espalier {

/// When it is asked how a scan is to be read.
enum class Asking : std::uint8_t { never, ifUnclear, always };

/// Columns that were named by hand, by what such files have in common.
using NamedColumns = QHash<QString, std::vector<PointField>>;

/// What texts have in common whose columns hold the same: the line that names them, else how many
/// there are and why they are in doubt; empty: nothing, of columns that are clear.
[[nodiscard]] QString columnsKey(const FirstLines& text);

/// As the settings have them.
[[nodiscard]] NamedColumns namedColumns(const QSettings& settings);
void keepNamedColumns(QSettings& settings, const NamedColumns& named);

/// A look at the one scan among the files; none if there is none, or several, or if only reading it
/// all would show what it is and nobody asked for that. Of a text that cannot be read as it seems
/// to be, it says why: other columns may do.
/// @throws Error why the file cannot be read
[[nodiscard]] std::optional<ScanLook> lookAtScan(const QStringList& paths, Asking asking,
                                                 const NamedColumns& known);

} // namespace espalier
