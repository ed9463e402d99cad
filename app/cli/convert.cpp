#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/plant_file.h"
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
  bool isOfPoints = false; // of a project
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

Content contentToWrite(const ConvertFlags& flags) {
  if (isProject(flags.input)) return flags.isOfPoints ? Content::points : Content::structure;
  if (flags.isOfPoints)
    throw WrongUsage(flags.input + ": is no project: --points is for those, leave it out");
  return formatOf(flags.input).content;
}

void convertPoints(const ConvertFlags& flags) {
  const TerminalProgress terminal;
  std::shared_ptr<const PointCloud> points;
  if (isProject(flags.input)) {
    const Project project = Project::open(flags.input, Access::readOnly);
    const Imported<History> history = project.history();
    printNotes(history.notes);
    points = pointsOf(project, history.value.leftOut, terminal.progress().part(0, 0.5));
    if (!points)
      throw Error(flags.input + ": its points cannot be read: give its scan, or put it beside it");
  } else {
    auto read = readPoints(flags.input, flags.read.options(), terminal.progress().part(0, 0.5));
    printNotes(read.notes);
    points = std::make_shared<const PointCloud>(std::move(read.value));
  }
  terminal.check();
  terminal.clear();
  writeAndReport(flags.output, *points, points->positions(), terminal.progress().part(0.5, 1));
}

void convertStructure(const ConvertFlags& flags) {
  const TerminalProgress terminal;
  Structure structure;
  if (isProject(flags.input)) {
    structure = plantIn(flags.input);
  } else {
    auto read = readAnyStructure(flags.input);
    printNotes(read.notes);
    structure = std::move(read.value);
  }
  terminal.check();
  terminal.clear();
  if (flags.rewrites) {
    structure = withoutText(structure, flags);
    for (const std::string& limit : openAleaLimits(structure.frame->mtg))
      printNotes({"OpenAlea: " + limit});
  }
  if (flags.mtgStyle != MtgStyle::plantNode && structure.frame)
    printNotes({flags.input + ": has scales of its own, and keeps them: --mtg-scales is for "
                              "structures without"});
  writeAndReport(flags.output, structure, flags.mtgStyle);
}

void convert(const ConvertFlags& flags) {
  const Content content = contentToWrite(flags);
  requireOutput(flags.output, content, {flags.input});
  if (flags.rewrites && content == Content::points) throw nothingToRewrite(flags);
  if (isProject(flags.input))
    requireNoneOf(flags.read, flags.input, "a project");
  else if (content != Content::points)
    requireNoneOf(flags.read, flags.input, "a structure");
  content == Content::points ? convertPoints(flags) : convertStructure(flags);
}

} // namespace

void addConvert(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("convert", "Write points or a structure in another format");
  const auto flags = std::make_shared<ConvertFlags>();
  command
      ->add_option("INPUT", flags->input,
                   "Points, a structure or a project to read; of a project "
                   "the structure, unless --points is given")
      ->required();
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
  command->add_flag("--points", flags->isOfPoints,
                    "Of a project, write the points that are not set aside");
  command->callback([flags] { convert(*flags); });
  command->footer("Examples:\n"
                  "  espalier convert pine.las pine.ply\n"
                  "  espalier convert plot.laz sample.ply --most 5000000\n"
                  "  espalier convert pine.mtg pine.swc\n"
                  "  espalier convert pine.espalier pine.mtg\n"
                  "  espalier convert pine.espalier pine.ply --points\n"
                  "  espalier convert typed.mtg clean.mtg --rewrite\n"
                  "  espalier convert pine.swc pine.mtg --mtg-scales plant-axis-node\n"
                  "  espalier convert pine.mtg pine.internodes.csv   internode lengths and angles");
}

} // namespace espalier
