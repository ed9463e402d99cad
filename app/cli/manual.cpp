#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/headless.h"
#include "app/cli/terminal.h"
#include "app/report/manual_pages.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

namespace espalier {
namespace {

void writeManual(const std::string& folder) {
  const Headless headless;
  const std::vector<ManualPage> pages = manualPages();
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem || !std::filesystem::is_directory(folder))
    throw Error(folder + ": is no folder and cannot be made one: choose another");
  for (const ManualPage& page : pages) {
    const std::filesystem::path file = std::filesystem::path(folder) / page.file.toStdString();
    writeAtomically(file, [&](std::ostream& out) {
      out.write(page.bytes.constData(), static_cast<std::streamsize>(page.bytes.size()));
    });
  }
  printWritten((std::filesystem::path(folder) / "index.html").string() + ": the manual");
}

} // namespace

void addManual(CLI::App& app) {
  CLI::App* command = app.add_subcommand("manual", "Write the manual as web pages");
  const auto folder = std::make_shared<std::string>();
  command
      ->add_option("--html", *folder,
                   "Folder to write the pages and pictures to, which is made if it is not there")
      ->type_name("FOLDER")
      ->required();
  command->callback([folder] { writeManual(*folder); });
  command->footer("Open index.html there in a browser. Pages of before are replaced.\n\n"
                  "Example:\n"
                  "  espalier manual --html manual");
}

} // namespace espalier
