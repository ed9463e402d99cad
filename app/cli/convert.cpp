#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/terminal.h"

#include <memory>
#include <string>

namespace espalier {
namespace {

struct Flags {
  std::string input;
  std::string output;
};

void convert(const Flags& flags) {
  const Content content = formatOf(flags.input).content;
  requireOutput(flags.output, content, {flags.input});
  const TerminalProgress terminal;
  if (content == Content::points) {
    const auto points = readPoints(flags.input, terminal.progress());
    printNotes(points.notes);
    terminal.check();
    writePoints(flags.output, points.value);
  } else {
    const auto structure = readStructure(flags.input);
    printNotes(structure.notes);
    terminal.check();
    writeStructure(flags.output, structure.value);
  }
}

} // namespace

void addConvert(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("convert", "Write points or a structure in another format");
  const auto flags = std::make_shared<Flags>();
  command->add_option("INPUT", flags->input, "Points or a structure to read")->required();
  command
      ->add_option("OUTPUT", flags->output,
                   "File to write, in the format of its extension: points as .ply, .xyz, .asc, "
                   ".txt, .csv or .pts, a structure as .mtg or .txt")
      ->required();
  command->callback([flags] { convert(*flags); });
  command->footer("Examples:\n"
                  "  espalier convert pine.las pine.ply\n"
                  "  espalier convert pine.mtg pine.txt");
}

} // namespace espalier
