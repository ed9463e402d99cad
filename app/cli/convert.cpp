#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/io/formats.h"

#include <CLI/CLI.hpp>

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
  (void)formatToWrite(flags.output, content);
  if (content == Content::points) {
    const TerminalProgress terminal;
    const auto points = readPoints(flags.input, terminal.progress());
    printNotes(points.notes);
    writePoints(flags.output, points.value);
  } else {
    const auto structure = readStructure(flags.input);
    printNotes(structure.notes);
    writeStructure(flags.output, structure.value);
  }
}

} // namespace

void addConvert(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("convert", "Write points or a structure in another format");
  const auto flags = std::make_shared<Flags>();
  command->add_option("input", flags->input, "File to read")->required();
  command->add_option("output", flags->output, "File to write; its extension tells the format")
      ->required();
  command->callback([flags] { convert(*flags); });
}

} // namespace espalier
