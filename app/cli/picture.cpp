#include "ui/view/picture.h"

#include "app/cli/commands.h"
#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/formats.h"

#include <CLI/CLI.hpp>
#include <QBuffer>
#include <QGuiApplication>

#include <algorithm>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace espalier {
namespace {

struct Flags {
  std::vector<std::string> files;
  std::string output;
  StandardView view = StandardView::front;
  std::vector<std::string> layers;
  PointColor color = PointColor::height;
  int width = 1280;
  int height = 800;
  bool isDark = false;
  bool showRadii = false;
  std::string unit;
};

Scene sceneOf(const Flags& flags, const Progress& progress) {
  Scene scene;
  bool hasStructure = false;
  for (const std::string& file : flags.files) {
    if (formatOf(file).content == Content::points) {
      if (scene.cloud) throw Error(file + ": a picture shows one scan; give one file of points");
      auto points = readPoints(file, progress);
      printNotes(points.notes);
      scene.setCloud(std::make_shared<const PointCloud>(std::move(points.value)));
    } else {
      if (hasStructure) throw Error(file + ": a picture shows one structure; give one");
      const auto structure = readStructure(file);
      printNotes(structure.notes);
      scene.setSkeleton(structure.value);
      hasStructure = true;
    }
  }
  const auto isWanted = [&](const std::string& layer) {
    return flags.layers.empty() ||
           std::find(flags.layers.begin(), flags.layers.end(), layer) != flags.layers.end();
  };
  scene.points.visible = isWanted("points");
  scene.skeletonVisible = isWanted("skeleton");
  scene.setPointColor(flags.color);
  scene.setDark(flags.isDark);
  scene.showRadii = flags.showRadii;
  return scene;
}

void drawPicture(const Flags& flags) {
  // Drawing needs no display, but Qt an application.
  qputenv("QT_QPA_PLATFORM", "offscreen");
  int argc = 1;
  std::string name = "espalier";
  char* argv[] = {name.data(), nullptr};
  const QGuiApplication application(argc, argv);

  const TerminalProgress terminal;
  const Scene scene = sceneOf(flags, terminal.progress());
  const QSize size(flags.width, flags.height);
  const Camera camera =
      cameraOf(scene, flags.view, static_cast<double>(flags.width) / flags.height);
  const QImage image = picture(scene, camera, {.unit = QString::fromStdString(flags.unit)}, size);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  writeAtomically(flags.output, [&](std::ostream& out) {
    out.write(bytes.constData(), static_cast<std::streamsize>(bytes.size()));
  });
}

} // namespace

void addPicture(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("picture", "Draw a scan, a structure, or both, as the editor would");
  const auto flags = std::make_shared<Flags>();
  command->add_option("files", flags->files, "A scan, a structure, or both")->required();
  command->add_option("-o,--output", flags->output, "PNG file to write")->required();
  const std::map<std::string, StandardView> views = {{"front", StandardView::front},
                                                     {"back", StandardView::back},
                                                     {"left", StandardView::left},
                                                     {"side", StandardView::right},
                                                     {"top", StandardView::top},
                                                     {"bottom", StandardView::bottom},
                                                     {"isometric", StandardView::isometric}};
  command->add_option("--view", flags->view, "Side to look from")
      ->transform(CLI::CheckedTransformer(views))
      ->default_str("front");
  command->add_option("--layers", flags->layers, "What to show (default: all)")
      ->check(CLI::IsMember({"points", "skeleton"}))
      ->delimiter(',');
  const std::map<std::string, PointColor> colors = {{"uniform", PointColor::uniform},
                                                    {"height", PointColor::height},
                                                    {"intensity", PointColor::intensity},
                                                    {"rgb", PointColor::rgb}};
  command->add_option("--color", flags->color, "What the points are colored by")
      ->transform(CLI::CheckedTransformer(colors))
      ->default_str("height");
  command->add_option("--width", flags->width, "[pixels]")
      ->check(CLI::Range(16, 16384))
      ->capture_default_str();
  command->add_option("--height", flags->height, "[pixels]")
      ->check(CLI::Range(16, 16384))
      ->capture_default_str();
  command->add_flag("--dark", flags->isDark, "On a dark background");
  command->add_flag("--radii", flags->showRadii, "Draw the skeleton as thick as the plant");
  command->add_option("--unit", flags->unit, "Unit of lengths, for the scale bar")
      ->check(CLI::IsMember({"mm", "cm", "m"}));
  command->callback([flags] { drawPicture(*flags); });
}

} // namespace espalier
