#pragma once

#include <QIcon>
#include <QString>

namespace espalier {

/// The icon of this name in resources/icons, drawn in the text color of the palette it is shown
/// with: it follows the theme by itself.
[[nodiscard]] QIcon themedIcon(const QString& name);

/// The icon of the program, in its own colors.
[[nodiscard]] QIcon programIcon();

} // namespace espalier
