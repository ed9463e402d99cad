#pragma once

#include "core/base/shown_message.h"

#include <QString>

#include <exception>

namespace espalier {

/// A sentence of core with its values, in the language of the window.
[[nodiscard]] QString shownText(const ShownMessage& message);

/// What an error says: that of a ShownError in the language of the window.
[[nodiscard]] QString shownText(const std::exception& error);

} // namespace espalier
