#include "app/cli/command_line.h"

#include "app/about/version.h"
#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/help.h"
#include "app/cli/terminal.h"
#include "core/base/progress.h"
#include "core/base/text.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace espalier {
namespace {

constexpr int done = 0;
constexpr int failed = 1;
constexpr int wrongUsage = 2;
constexpr int stopped = 130;

void addAll(CLI::App& app) {
  app.formatter(makeHelpFormatter());
  app.set_help_flag("-h,--help", "Print this help");
  app.require_subcommand(1);
  addReconstruct(app);
  addBatch(app);
  addContract(app);
  addClean(app);
  addSmooth(app);
  addPlants(app);
  addRegister(app);
  addSweep(app);
  addEvaluate(app);
  addTraits(app);
  addEnvelope(app);
  addConsensus(app);
  addNoise(app);
  addConvert(app);
  addInfo(app);
  addSimulate(app);
  addMethods(app);
  addManual(app);
  addPicture(app);
  addAnswer(app);
  // What subcommands would inherit comes after them.
  app.set_version_flag("--version", "espalier " + programVersion(), "Print the version");
  app.footer("\"espalier SUBCOMMAND --help\" describes one. Results go to files, messages\n"
             "to standard error. Exit status: 0 done, 1 an error in one line, 2 wrong\n"
             "usage, 130 stopped by Ctrl+C.");
}

bool isSubcommand(const CLI::App& app, const std::string& name) {
  return !app.get_subcommands([&](const CLI::App* each) { return each->get_name() == name; })
              .empty();
}

/// Whether a first argument can only be meant for a subcommand: no file, nor the name of one.
bool isMistypedSubcommand(const std::string& argument) {
  std::error_code isMissing;
  return argument.find_first_of("./") == std::string::npos &&
         !std::filesystem::exists(argument, isMissing);
}

/// What is wrong with a first argument that is no subcommand.
std::string unknownFirst(const CLI::App& app, const std::string& argument) {
  std::vector<std::string> names;
  for (const CLI::App* each : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(each->get_name());
  const std::string like = nameLike(argument, names);
  return inQuotes(argument) + " is no file, subcommand or option" +
         (like.empty() ? "" : ": did you mean " + like + "?");
}

std::string helpHint(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  const std::string name = chosen.empty() ? "espalier" : "espalier " + chosen.front()->get_name();
  return "; see \"" + name + " --help\"";
}

/// "--method is given 2 times: give it once": CLI11 ends its message with how many values there
/// are.
std::string mismatchMessage(const std::string& what) {
  const std::string name = what.substr(0, what.find(": "));
  const std::size_t digits = what.find_last_not_of("0123456789") + 1;
  const std::string given = what.substr(digits);
  if (given.empty() || given == "0") return name + " needs a value";
  constexpr std::string_view fewest = "At least ";
  if (const std::size_t at = what.find(fewest); at != std::string::npos)
    return name + " needs " + std::to_string(std::atoi(what.c_str() + at + fewest.size())) +
           " values, and is given " + given;
  return name + " is given " + given + " times: give it once";
}

/// What is wrong with arguments that are left over, "x.mtg -o": with the flag, if there is one.
std::string notExpected(const std::string& arguments) {
  std::istringstream parts(arguments);
  for (std::string part; parts >> part;)
    if (part.starts_with('-')) return part + " is no option";
  return arguments + " is not expected here";
}

/// What is wrong with the arguments, with the name of the subcommand whose help says more.
std::string usageMessage(const CLI::App& app, const CLI::ParseError& problem) {
  std::string what = problem.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&problem) != nullptr)
    what = notExpected(what.substr(what.find(": ") + 2));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&problem) != nullptr) what = mismatchMessage(what);
  return what + helpHint(app);
}

int fail(int status, const std::string& message) {
  printLine(message);
  return status;
}

/// Parses the arguments, which runs the subcommand they name.
int run(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return done;
  } catch (const CLI::Success& help) { // help or version was asked for
    return app.exit(help);
  } catch (const CLI::ParseError& problem) {
    return fail(wrongUsage, usageMessage(app, problem));
  } catch (const WrongUsage& problem) {
    return fail(wrongUsage, problem.what() + helpHint(app));
  } catch (const StoppedBetween& stop) {
    return fail(stopped, stop.message);
  } catch (const Cancelled&) {
    return fail(stopped, "stopped; nothing was written");
  } catch (const std::bad_alloc&) {
    return fail(failed, "not enough memory: close other programs, or thin the scan");
  } catch (const std::exception& problem) {
    return fail(failed, problem.what());
  }
}

} // namespace

bool isForCommandLine(int argc, char** argv) {
  if (argc < 2) return false;
  CLI::App app;
  addAll(app);
  const std::string first = argv[1];
  return first.starts_with('-') || isSubcommand(app, first) || isMistypedSubcommand(first);
}

int runCommandLine(int argc, char** argv) {
  CLI::App app("Espalier: from a laser scan of a plant to a skeleton an expert would sign",
               "espalier");
  addAll(app);
  if (argc > 1 && !isSubcommand(app, argv[1]) && app.get_option_no_throw(argv[1]) == nullptr)
    return fail(wrongUsage, unknownFirst(app, argv[1]) + "; see \"espalier --help\"");
  if (argc > 1 && isSubcommand(app, argv[1])) {
    const std::string unknown = unknownOption(*app.get_subcommand(argv[1]),
                                              std::vector<std::string>(argv + 2, argv + argc));
    if (!unknown.empty())
      return fail(wrongUsage, unknown + "; see \"espalier " + argv[1] + " --help\"");
  }
  const int status = run(app, argc, argv);
  std::cout.flush();
  if (status == done && (!std::cout || std::fflush(stdout) != 0))
    return fail(failed, "standard output cannot be written: free some room or write elsewhere");
  return status;
}

} // namespace espalier
