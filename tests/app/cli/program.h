#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace espalier::test {

/// What a run of the program left behind.
struct Outcome {
  int status = 0; // of exit; 128 + the signal that ended it, as shells have it
  std::string out;
  std::string err;
};

using Arguments = std::vector<std::string>;

/// Runs the built program to its end, without a display or a terminal.
/// @param stdoutFile where standard output goes instead of into the outcome; empty: there
[[nodiscard]] Outcome runProgram(const Arguments& arguments, const std::string& stdoutFile = {});

/// Runs it with one more variable, as "NAME=value".
[[nodiscard]] Outcome runWith(const std::string& variable, const Arguments& arguments);

/// Runs it with a terminal as standard error, and sends `signal` once `text` is seen there.
/// @return err is what the terminal showed
[[nodiscard]] Outcome runAndSignal(const Arguments& arguments, const std::string& text, int signal);

/// A file of the bundled sample: "young_tree.ply" or "young_tree.mtg".
[[nodiscard]] std::string sample(const std::string& name);

[[nodiscard]] std::string bytesOf(const std::filesystem::path& file);
[[nodiscard]] nlohmann::json jsonIn(const std::filesystem::path& file);
void writeBytes(const std::filesystem::path& file, const std::string& bytes);

/// The names of all there is in a folder, sorted.
[[nodiscard]] std::vector<std::string> namesIn(const std::filesystem::path& folder);

/// Expects that a run ended with `status` and said why in one line that holds all of `parts`.
void expectRefusal(const Outcome& outcome, int status, const std::vector<std::string>& parts);

} // namespace espalier::test
