#pragma once

namespace espalier {

/// Returns whether these arguments are for the command line rather than for the editor.
[[nodiscard]] bool isForCommandLine(int argc, char** argv);

/// Runs a subcommand without a display.
/// @return the exit status: 0 done, 1 an error that was said in one line, 2 wrong usage, 130
/// stopped
[[nodiscard]] int runCommandLine(int argc, char** argv);

} // namespace espalier
