#pragma once

#include <memory>

namespace CLI {
class FormatterBase;
}

namespace espalier {

/// Lays out the help of the program and of its subcommands: usage, then each argument with what it
/// takes, what it does and what it is when not given, within 80 columns.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> makeHelpFormatter();

} // namespace espalier
