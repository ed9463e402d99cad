#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace espalier::test {

std::optional<std::filesystem::path> sharedFile(const std::filesystem::path& name) {
  const char* folder = std::getenv("ESPALIER_SHARED_DATA");
  const std::filesystem::path path =
      std::filesystem::path(folder != nullptr ? folder : ESPALIER_SHARED_DATA) / name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path;
}

std::filesystem::path freshFolder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  for (char& c : name)
    if (c == '/') c = '_';
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "espalier_tests" / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

std::filesystem::path sourceFolder() {
  return ESPALIER_SOURCE_DIR;
}

} // namespace espalier::test
