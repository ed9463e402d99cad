// What the main option of each contraction and of each reconstruction does: three pictures of one
// plant, with a quarter of the default, the default, and four times it.
#include "core/pipeline/pipeline.h"
#include "core/pipeline/registry.h"
#include "core/simulate/laser_scanner.h"
#include "core/simulate/plant_grower.h"
#include "tests/pictures/studio.h"
#include "ui/view/picture.h"

#include <algorithm>
#include <memory>

namespace espalier {
namespace {

class OptionPictures : public test::Studio {
protected:
  void SetUp() override {
    Studio::SetUp();
    const Skeleton plant = growPlant({.height = 1, .segments = 24}, 9);
    cloud_ = std::make_shared<const PointCloud>(scan(plant, {.points = 9000}, 9).points);
  }

  /// The part of the plant that shows twigs and the wood that bears them.
  QImage shownUpTo(const Step& step, const PipelineOptions& options) {
    const Reconstruction made = Pipeline().run(cloud_, options, {}, step.name);
    Scene scene;
    scene.setPointColor(PointColor::uniform);
    if (made.contracted && step.name == contractionStep().name)
      scene.setCloud(contractedCloud(*made.contracted));
    else
      scene.setCloud(cloud_);
    if (step.name == skeletonStep().name) {
      scene.setSkeleton(*made.skeleton);
      scene.points.visible = false; // they would hide it
    }
    constexpr QSize size(300, 300);
    Scene whole; // all are seen from one place
    whole.setCloud(cloud_);
    const Camera camera = cameraOf(whole, StandardView::front, 1);
    const QImage all = picture(scene, camera, {.isBare = true}, size * 3);
    return all.copy(QRect(QPoint(size.width(), size.height() * 3 / 2), size * 3 / 2))
        .scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_RGB32);
  }

  std::shared_ptr<const PointCloud> contractedCloud(const Eigen::Matrix3Xf& positions) {
    RawPoints raw;
    for (const auto& position : positions.colwise())
      raw.positions.emplace_back(cloud_->origin() + position.cast<double>());
    return std::make_shared<const PointCloud>(std::move(raw));
  }

  std::shared_ptr<const PointCloud> cloud_;
};

/// The first length of a method: its radius, or how far its nodes are apart.
const Option* mainOption(const Method& method) {
  const auto found = std::ranges::find(method.options, OptionKind::length, &Option::kind);
  return found == method.options.end() ? nullptr : &*found;
}

TEST_F(OptionPictures, OfContractionsAndReconstructions) {
  const PlantScale scale =
      Pipeline().run(cloud_, {}, {}, contractionStep().name).steps.back().scale;
  for (const Step* step : {&contractionStep(), &skeletonStep()})
    for (const Method& method : step->methods) {
      const Option* option = mainOption(method);
      if (option == nullptr) continue;
      std::vector<QImage> images;
      for (const double factor : {0.25, 1.0, 4.0}) {
        const auto [least, most] = option->range(scale);
        PipelineOptions options;
        options.methods[step->name] = method.name;
        options.settings[step->name][option->name] =
            fixedAt(std::clamp(factor * option->rule.value(scale), least, most));
        images.push_back(shownUpTo(*step, options));
      }
      save(test::together(images, 3),
           QString::fromStdString("option-" + step->name + "-" + method.name + "-" + option->name +
                                  ".png"));
    }
}

} // namespace
} // namespace espalier
