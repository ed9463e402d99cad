#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <unistd.h>

namespace espalier::test {

std::optional<std::filesystem::path> sharedFile(const std::filesystem::path& name) {
  const char* folder = std::getenv("ESPALIER_SHARED_DATA");
  const std::filesystem::path path =
      std::filesystem::path(folder != nullptr ? folder : ESPALIER_SHARED_DATA) / name;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path;
}

namespace {

/// A folder of this run alone, so that two checkouts can be tested at once; gone when the run ends.
class RunFolder {
public:
  RunFolder()
      : path_(std::filesystem::temp_directory_path() /
              ("espalier_tests_" + std::to_string(getpid()))) {}
  ~RunFolder() {
    std::error_code ignored; // what a failed test left locked stays
    std::filesystem::remove_all(path_, ignored);
  }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace

std::filesystem::path freshFolder() {
  static const RunFolder run;
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  for (char& c : name)
    if (c == '/') c = '_';
  const std::filesystem::path folder = run.path() / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

std::filesystem::path sourceFolder() {
  return ESPALIER_SOURCE_DIR;
}

} // namespace espalier::test
