#include "ui/view/picture.h"

#include "app/cli/arguments.h"
#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/headless.h"
#include "app/cli/plant_file.h"
#include "app/cli/terminal.h"
#include "core/base/text.h"
#include "core/cloud/point_set.h"
#include "core/io/atomic_file.h"
#include "ui/view/animated_png.h"
#include "ui/view/turntable.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace espalier {
namespace {

struct PictureFlags {
  std::vector<std::string> files;
  std::string output;
  StandardView view = StandardView::front;
  std::vector<std::string> layers;
  PointColor color = PointColor::height;
  int width = 1280;
  int height = 800;
  bool isDark = false;
  bool showRadii = false;
  bool isBare = false;
  int turntable = 0; // seconds of a turn; 0: a picture that stays
  std::string unit;
};

/// @throws Error if points cannot be colored by what they do not have
void requireColor(const PointCloud& cloud, PointColor color) {
  const bool lacks = (color == PointColor::intensity && cloud.intensities().empty()) ||
                     (color == PointColor::rgb && cloud.colors().empty());
  if (lacks)
    throw WrongUsage("the points of the scan have no " +
                     std::string(color == PointColor::rgb ? "colors" : "intensities") +
                     ": choose another --color");
}

/// @param hasPoints  whether they are drawn: else no scan is read
void setProject(Scene& scene, const std::string& file, bool hasPoints, const Progress& progress) {
  const Project project = Project::open(file, Access::readOnly);
  const Imported<History> history = project.history();
  printNotes(history.notes);
  if (!hasPoints && history.value.skeleton.isEmpty())
    throw Error(file + ": has no skeleton to draw: draw its points");
  if (auto cloud = hasPoints ? pointsOf(project, history.value.leftOut, progress) : nullptr;
      cloud && !cloud->isEmpty())
    scene.setCloud(std::move(cloud));
  scene.setSkeleton(history.value.skeleton);
}

Scene sceneOf(const PictureFlags& flags, const Progress& progress) {
  const auto isWanted = [&](const std::string& layer) {
    return flags.layers.empty() ||
           std::find(flags.layers.begin(), flags.layers.end(), layer) != flags.layers.end();
  };
  Scene scene;
  bool hasStructure = false;
  for (const std::string& file : flags.files) {
    if (isProject(file)) {
      if (flags.files.size() > 1)
        throw Error(file + ": a project is drawn by itself: give it alone");
      setProject(scene, file, isWanted("points"), progress);
      continue;
    }
    if (formatOf(file).content == Content::points) {
      if (scene.cloud) throw Error(file + ": a picture shows one scan; give one file of points");
      auto points = readPoints(file, progress);
      printNotes(points.notes);
      scene.setCloud(std::make_shared<const PointCloud>(std::move(points.value)));
    } else {
      if (hasStructure) throw Error(file + ": a picture shows one structure; give one");
      const auto structure = readStructure(file);
      printNotes(structure.notes);
      scene.setSkeleton(structure.value.skeleton);
      hasStructure = true;
    }
  }
  if (scene.cloud) requireColor(*scene.cloud, flags.color);
  const bool hasPoints = scene.cloud && isWanted("points");
  const bool hasSkeleton = !scene.skeleton.bounds().isEmpty() && isWanted("skeleton");
  if (!hasPoints && !hasSkeleton)
    throw Error(flags.files.front() +
                (flags.layers.empty() ? ": is empty: there is nothing to draw"
                 : scene.cloud ? ": has no skeleton to draw: give a structure, or no --layers"
                               : ": has no points to draw: give a scan, or no --layers"));
  scene.points.visible = isWanted("points");
  scene.skeletonVisible = isWanted("skeleton");
  scene.setPointColor(flags.color);
  scene.setDark(flags.isDark);
  scene.showRadii = flags.showRadii;
  return scene;
}

void requirePng(const std::string& path) {
  const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
  if (extension == ".png") return;
  if (!isStream(path) || !extension.empty())
    throw Error(path + ": pictures are written as PNG: choose a name that ends in .png");
}

void drawPicture(const PictureFlags& flags) {
  if (!flags.isBare) requirePng(flags.output); // a desktop names its thumbnails as it likes
  requireOutput(flags.output, flags.files);
  const Headless headless;
  const TerminalProgress terminal;
  const Scene scene = sceneOf(flags, terminal.progress());
  // A small picture without text is drawn larger first: thin wood stays fine in it.
  const QSize wanted(flags.width, flags.height);
  const QSize size =
      flags.isBare && flags.width <= 1024 && flags.height <= 1024 ? wanted * 2 : wanted;
  const Camera camera =
      cameraOf(scene, flags.view, static_cast<double>(flags.width) / flags.height);
  const QImage image = picture(
      scene, camera, {.unit = QString::fromStdString(flags.unit), .isBare = flags.isBare}, size);
  const QByteArray bytes =
      pngOf(size == wanted ? image
                           : image.scaled(wanted, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  terminal.check();
  writeAndReport(
      flags.output,
      [&](std::ostream& out) {
        out.write(bytes.constData(), static_cast<std::streamsize>(bytes.size()));
      },
      std::to_string(flags.width) + " x " + std::to_string(flags.height) + " pixels");
}

void drawTurntable(const PictureFlags& flags) {
  requirePng(flags.output);
  requireOutput(flags.output, flags.files);
  const Headless headless;
  const TerminalProgress terminal;
  const Scene scene = sceneOf(flags, terminal.progress().part(0, 0.1));
  const TurntableOptions options{.size = QSize(flags.width, flags.height),
                                 .seconds = flags.turntable};
  Turntable turntable(
      scene, cameraAround(scene, flags.view, static_cast<double>(flags.width) / flags.height),
      {.unit = QString::fromStdString(flags.unit), .isBare = flags.isBare}, options);
  const int count = options.frames();
  const Progress progress = terminal.progress().part(0.1, 1, "Drawing");
  writeAndReport(
      flags.output,
      [&](std::ostream& out) {
        AnimatedPng movie(out, static_cast<std::uint32_t>(count), TurntableOptions::perSecond);
        for (int i = 0; i < count; ++i) {
          movie.add(turntable.frame(i));
          progress.update(static_cast<double>(i + 1) / count);
        }
      },
      std::to_string(count) + " pictures, " + std::to_string(flags.width) + " x " +
          std::to_string(flags.height) + " pixels");
}

} // namespace

void addPicture(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "picture", "Draw a scan, a structure, both, or a project, as the editor would");
  const auto flags = std::make_shared<PictureFlags>();
  command->add_option("FILE", flags->files, "A scan, a structure, one of each, or a project")
      ->required();
  addOutput(*command, flags->output, "PNG picture to write");
  addChoice(*command, "--view", flags->view, "Side to look from",
            {{"front", StandardView::front},
             {"back", StandardView::back},
             {"left", StandardView::left},
             {"right", StandardView::right},
             {"side", StandardView::right},
             {"top", StandardView::top},
             {"bottom", StandardView::bottom},
             {"isometric", StandardView::isometric}});
  command->add_option("--layers", flags->layers, "What to show, parted by commas: points, skeleton")
      ->type_name("LIST")
      ->default_str("all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(oneOf({"points", "skeleton"}));
  addChoice(*command, "--color", flags->color, "What the points are colored by",
            {{"uniform", PointColor::uniform},
             {"height", PointColor::height},
             {"intensity", PointColor::intensity},
             {"rgb", PointColor::rgb}});
  for (const auto& [option, size] :
       {std::pair{"--width", &flags->width}, std::pair{"--height", &flags->height}})
    command->add_option(option, *size, "Size of the picture in pixels, 16 to 16384")
        ->type_name("N")
        ->check(wholeNumber(16, 16384))
        ->capture_default_str();
  command->add_flag("--dark", flags->isDark, "On a dark background");
  command->add_flag("--radii", flags->showRadii, "Draw the skeleton as thick as the plant");
  command->add_flag("--bare", flags->isBare,
                    "Without scale bar, axes and colors explained; the file may have any name");
  command
      ->add_option("--turntable", flags->turntable,
                   "Writes a movie instead, an animated PNG: the plant turns once, in so many "
                   "seconds, 2 to 60")
      ->type_name("SECONDS")
      ->check(wholeNumber(TurntableOptions::leastSeconds, TurntableOptions::mostSeconds));
  addUnit(*command, flags->unit, "Unit of lengths, for the scale bar");
  command->callback([flags] {
    flags->unit = unitOfPlant(flags->files.front(), flags->unit);
    if (flags->turntable > 0)
      drawTurntable(*flags);
    else
      drawPicture(*flags);
  });
  command->footer("Example:\n"
                  "  espalier picture pine.las pine.mtg -o pine.png --view side");
}

} // namespace espalier
