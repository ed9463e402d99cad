#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/read_flags.h"
#include "app/cli/terminal.h"
#include "core/mtg/openalea_limits.h"

#include <memory>
#include <string>

namespace espalier {
namespace {

struct ConvertFlags {
  std::string input;
  std::string output;
  ReadFlags read; // which points
  MtgStyle mtgStyle = MtgStyle::plantNode;
  bool rewrites = false;
};

/// ".ply, .xyz, ...": those that formats of this content are written by.
std::string extensionsToWrite(Content content) {
  std::string list;
  for (const Format& format : formats()) {
    if (format.content != content || !format.canWrite()) continue;
    for (const std::string_view extension : format.extensions) {
      const std::string item = "." + std::string(extension);
      if (list.find(item + ',') == std::string::npos) list += item + ", ";
    }
  }
  return list.substr(0, list.size() - 2);
}

Error nothingToRewrite(const ConvertFlags& flags) {
  return Error(flags.output + ": --rewrite is for MTG to MTG: leave it out");
}

/// The same without the text it was read from, so that all of it is written anew.
Structure withoutText(const Structure& structure, const ConvertFlags& flags) {
  if (!structure.frame || formatToWrite(flags.output, Content::structure).name != "MTG")
    throw nothingToRewrite(flags);
  return {structure.skeleton, std::make_shared<const MtgFrame>(MtgFrame{structure.frame->mtg, {}})};
}

void convert(const ConvertFlags& flags) {
  const Content content = formatOf(flags.input).content;
  requireOutput(flags.output, content, {flags.input});
  if (flags.rewrites && content == Content::points) throw nothingToRewrite(flags);
  if (content != Content::points) requireNoneOf(flags.read, flags.input, "a structure");
  const TerminalProgress terminal;
  if (content == Content::points) {
    const auto points =
        readPoints(flags.input, flags.read.options(), terminal.progress().part(0, 0.5));
    printNotes(points.notes);
    terminal.check();
    terminal.clear();
    writeAndReport(flags.output, points.value, points.value.positions(),
                   terminal.progress().part(0.5, 1));
  } else {
    auto structure = readAnyStructure(flags.input);
    printNotes(structure.notes);
    terminal.check();
    terminal.clear();
    if (flags.rewrites) {
      structure.value = withoutText(structure.value, flags);
      for (const std::string& limit : openAleaLimits(structure.value.frame->mtg))
        printNotes({"OpenAlea: " + limit});
    }
    if (flags.mtgStyle != MtgStyle::plantNode && structure.value.frame)
      printNotes({flags.input + ": has scales of its own, and keeps them: --mtg-scales is for "
                                "structures without"});
    writeAndReport(flags.output, structure.value, flags.mtgStyle);
  }
}

} // namespace

void addConvert(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("convert", "Write points or a structure in another format");
  const auto flags = std::make_shared<ConvertFlags>();
  command->add_option("INPUT", flags->input, "Points or a structure to read")->required();
  command
      ->add_option("OUTPUT", flags->output,
                   "File to write, in the format of its extension: points as " +
                       extensionsToWrite(Content::points) + ", a structure as " +
                       extensionsToWrite(Content::structure))
      ->required();
  flags->read.addTo(*command);
  addMtgStyle(*command, flags->mtgStyle);
  command->add_flag("--rewrite", flags->rewrites,
                    "Write an MTG anew: a vertex per line, columns and sections as other programs "
                    "write them. Without it an MTG keeps its text");
  command->callback([flags] { convert(*flags); });
  command->footer("Examples:\n"
                  "  espalier convert pine.las pine.ply\n"
                  "  espalier convert plot.laz sample.ply --most 5000000\n"
                  "  espalier convert pine.mtg pine.swc\n"
                  "  espalier convert typed.mtg clean.mtg --rewrite\n"
                  "  espalier convert pine.swc pine.mtg --mtg-scales plant-axis-node\n"
                  "  espalier convert pine.mtg pine.internodes.csv   internode lengths and angles");
}

} // namespace espalier
