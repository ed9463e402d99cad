#include "app/cli/command_line.h"

#include "app/cli/commands.h"
#include "core/base/progress.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace espalier {
namespace {

void addAll(CLI::App& app) {
  app.require_subcommand(1);
  app.set_version_flag("--version", "espalier " ESPALIER_VERSION);
  app.footer("Without a subcommand, espalier [FILE ...] opens the editor.");
  addReconstruct(app);
  addContract(app);
  addEvaluate(app);
  addConvert(app);
  addInfo(app);
  addSimulate(app);
  addMethods(app);
  addPicture(app);
}

} // namespace

bool isForCommandLine(int argc, char** argv) {
  if (argc < 2) return false;
  CLI::App app;
  addAll(app);
  const std::string first = argv[1];
  const auto commands =
      app.get_subcommands([&](const CLI::App* c) { return c->get_name() == first; });
  return !commands.empty() || first == "--help" || first == "-h" || first == "--version";
}

int runCommandLine(int argc, char** argv) {
  constexpr int error = 1;
  constexpr int wrongUsage = 2;
  constexpr int stopped = 130;
  CLI::App app("Espalier: from a laser scan of a plant to a skeleton an expert would sign",
               "espalier");
  addAll(app);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& problem) {
    return app.exit(problem) == 0 ? 0 : wrongUsage;
  } catch (const Cancelled&) {
    std::cerr << "espalier: stopped; nothing was written\n";
    return stopped;
  } catch (const std::bad_alloc&) {
    std::cerr << "espalier: not enough memory: close other programs, or thin the scan\n";
    return error;
  } catch (const std::exception& problem) {
    std::cerr << "espalier: " << problem.what() << '\n';
    return error;
  }
}

} // namespace espalier
