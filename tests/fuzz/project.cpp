// Fuzz target: whatever the bytes, all of a project can be read or is refused with an Error, and so
// is an edit of what was read without a note.
#include "core/project/project.h"

#include "core/base/error.h"
#include "core/project/contracted_points.h"
#include "core/project/point_bytes.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <unistd.h>

namespace espalier {
namespace {

namespace fs = std::filesystem;

/// A folder of this process, in memory where there is one: a file per input is much for a disk.
fs::path makeFolder() {
  const fs::path memory = "/dev/shm";
  const fs::path place = fs::is_directory(memory) ? memory : fs::temp_directory_path();
  fs::path folder = place / ("espalier-fuzz-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  return folder;
}

struct Folder {
  fs::path path = makeFolder();
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

template <class Read> void attempt(const Read& read) {
  try {
    (void)read();
  } catch (const Error&) { // what a broken file deserves
  }
}

void readAllOf(const Project& project) {
  attempt([&] { return project.history(); });
  for (const char* name : {"unit", "name", "file", "mtg", "made_with", "view"})
    attempt([&] { return project.document(name); });
  attempt([&] { return cloudFrom(project.bytes("cloud")); });
  attempt([&] { return contractedIn(project); });
  attempt([&] { return project.hasBytes("states"); });
  attempt([&] { return project.scan(); });
  attempt([&] { return project.findScan(); });
  attempt([&] { return project.needsSnapshot(); });
}

/// What a window does: an edit on top of what was read, and all of it kept elsewhere.
void editAndCopy(Project project, const fs::path& copy) {
  Imported<History> read = project.history();
  if (!read.notes.empty()) return;
  (void)Project::create(copy, read.value);
  SkeletonEditor editor(read.value.skeleton);
  editor.add({.position = {1, 2, 3}});
  const HistoryStep step = {.text = "Add node", .delta = editor.commit()};
  project.record(read.value.position, std::span(&step, 1), read.value.position + 1);
}

void write(const fs::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

} // namespace
} // namespace espalier

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace espalier;
  static const Folder folder;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const fs::path file = folder.path / "fuzz.espalier";
  write(file, bytes);
  (void)isProject(file);
  attempt([&] {
    readAllOf(Project::open(file, Access::readOnly));
    return 0;
  });
  attempt([&] {
    editAndCopy(Project::open(file, Access::readWrite), folder.path / "copy.espalier");
    return 0;
  });
  for (const fs::directory_entry& left : fs::directory_iterator(folder.path))
    fs::remove(left.path());
  return 0;
}
