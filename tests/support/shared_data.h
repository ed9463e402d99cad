#pragma once

#include <filesystem>
#include <optional>

namespace espalier::test {

/// The file of this name among the shared scans and references, if they are at hand: in the folder
/// of the environment variable ESPALIER_SHARED_DATA, or where the build was set to.
[[nodiscard]] std::optional<std::filesystem::path> sharedFile(const std::filesystem::path& name);

/// A folder of its own for the running test, empty at first.
[[nodiscard]] std::filesystem::path freshFolder();

/// The root of the project's sources.
[[nodiscard]] std::filesystem::path sourceFolder();

} // namespace espalier::test

/// Skips the running test, and says so, unless the shared file is at hand. Declares `variable`.
#define ESPALIER_SHARED_FILE(variable, name)                                                       \
  const auto variable##IfAny = ::espalier::test::sharedFile(name);                                 \
  if (!variable##IfAny) GTEST_SKIP() << "shared data not found: " << (name);                       \
  const std::filesystem::path& variable = *variable##IfAny
