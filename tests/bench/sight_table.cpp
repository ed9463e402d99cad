// How much of what one flies to is seen, in pictures of the view: of all findings of a structure
// over its scan, and of stops of the review by risk that are at wood.
//
//   espalier_sights SCAN STRUCTURE [STOPS [FINDINGS [FOLDER]]]   at most 100 and 1000
//
// Each is drawn alone and with all else; the share of its pixels that nothing else covers is what
// is printed: the median and the worst tenth of all, for the camera that is only brought nearer
// ("framed"), for the direction that is chosen ("turned"), for that with what is around stepped
// back ("focused"), for this beside the color bar, scale bar, axes and minimap of the window, which
// give way first ("beside"), and how long the choice took. With FOLDER, five pictures of each go
// there. Then how well the answers to questions are told apart, which printQuestionSights() has.
#include "core/decide/error_ratings.h"
#include "core/io/formats.h"
#include "core/pipeline/plant_scale.h"
#include "core/skeleton/checks.h"
#include "core/skeleton/checks_of_scan.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/review_stops.h"
#include "tests/bench/question_sights.h"
#include "ui/view/close_look.h"
#include "ui/view/minimap.h"
#include "ui/view/offscreen_renderer.h"
#include "ui/view/overlay.h"
#include "ui/view/picture.h"

#include <QApplication>
#include <QPainter>
#include <QString>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace espalier {
namespace {

constexpr int width = 900; // of the view in a window of 1280 x 800
constexpr int height = 640;

struct Subject {
  Sight sight;
  std::vector<NodeId> nodes;
  std::vector<Eigen::Index> points = {}; // beside those of its nodes
};

struct Plant {
  std::shared_ptr<const PointCloud> cloud;
  Skeleton skeleton;
  double spacing;
  PointDistances distances;
};

Plant read(const char* scan, const char* structure) {
  auto cloud = std::make_shared<const PointCloud>(readPoints(scan).value);
  Skeleton skeleton = readStructure(structure).value.skeleton;
  const double spacing = pointSpacing(cloud->positions());
  PointDistances distances(cloud, spacing, skeleton);
  return {cloud, std::move(skeleton), spacing, std::move(distances)};
}

template <class T> std::vector<T> some(const std::vector<T>& all, std::size_t most) {
  std::vector<T> chosen;
  for (std::size_t i = 0; i < std::min(all.size(), most); ++i)
    chosen.push_back(all[i * all.size() / std::min(all.size(), most)]);
  return chosen;
}

void addParents(Sight& sight, const Skeleton& skeleton) {
  for (const NodeId id : std::vector<NodeId>(sight.nodes))
    if (const auto parent = skeleton[id].parent) sight.nodes.push_back(*parent);
}

std::vector<Subject> findingsOf(const Plant& plant, std::size_t most) {
  const SpatialIndex index(plant.cloud->positions());
  std::vector<Finding> all = check(plant.skeleton, plant.spacing);
  const std::vector<Finding> ofScan =
      checkAgainstScan(plant.skeleton, plant.distances, index, plant.spacing);
  all.insert(all.end(), ofScan.begin(), ofScan.end());
  std::vector<Subject> subjects;
  for (const Finding& finding : some(all, most)) {
    Sight sight{.nodes = nodesOf(finding)};
    addParents(sight, plant.skeleton);
    for (const Eigen::Index point : finding.points)
      sight.places.push_back(plant.cloud->position(point));
    sight.margin = std::max(boundsOf(finding, plant.skeleton).diagonal().norm() / 2,
                            2 * meanEdgeLength(plant.skeleton));
    subjects.push_back({std::move(sight), nodesOf(finding), finding.points});
  }
  return subjects;
}

std::vector<Subject> stopsOf(const Plant& plant, std::size_t most) {
  const double longest = longestStretch(plant.skeleton);
  const ExpectedErrors errors{
      errorRatings(plant.skeleton, plant.distances, SpatialIndex(plant.cloud->positions()),
                   scaleOf(*plant.cloud, {}, UpAxis::z), Eigen::Vector3d::UnitZ())
          .ofEdges};
  std::vector<Subject> subjects;
  for (const ReviewStop& stop : some(reviewStops(plant.skeleton, &errors), most)) {
    Sight sight{.nodes = stop.nodes};
    addParents(sight, plant.skeleton);
    Eigen::AlignedBox3d box;
    for (const NodeId id : sight.nodes)
      box.extend(plant.skeleton[id].position);
    const double across = box.diagonal().norm(); // margins as ReviewFlow has them
    sight.margin = std::max(0.3 * across, 0.2 * longest);
    if (across <= longestLook * longest) sight.margin = std::min(sight.margin, 0.3 * longest);
    subjects.push_back({std::move(sight), stop.nodes});
  }
  return subjects;
}

/// Draws the plant with one subject in a color that nothing else has.
class Pictures {
public:
  explicit Pictures(const Plant& plant) : plant_(plant) {
    scene_.setCloud(plant.cloud);
    scene_.setSkeleton(plant.skeleton);
    first_ = cameraOf(scene_, StandardView::front, double(width) / height);
    renderer_ = std::make_unique<OffscreenRenderer>(scene_, makeSceneBuffers());
    overlay_.unit = "mm";
  }

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Camera& first() const { return first_; }
  void focusOn(const std::optional<Sight>& sight) {
    scene_.setFocus(sight ? std::optional(espalier::focusOn(plant_.skeleton, *sight))
                          : std::nullopt);
  }

  void mark(const Subject& subject) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    const auto points = static_cast<std::size_t>(plant_.cloud->size());
    isMeant_.assign(points, false);
    for (const Eigen::Index point : subject.points)
      isMeant_[static_cast<std::size_t>(point)] = true;
    std::vector<bool> isOfNode;
    for (const NodeId id : subject.nodes) {
      isOfNode.resize(std::max(isOfNode.size(), indexOf(id) + 1));
      isOfNode[indexOf(id)] = true;
    }
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t node = indexOf(plant_.distances.nearest()[i]);
      if (node < isOfNode.size() && isOfNode[node] &&
          plant_.distances.toSurface()[i] < 4 * plant_.spacing)
        isMeant_[i] = true;
    }
    std::vector<float> ofPoints(points, none);
    for (std::size_t i = 0; i < points; ++i)
      if (isMeant_[i]) ofPoints[i] = 0;
    std::vector<float> ofNodes(isOfNode.size(), none);
    hidden_.clear();
    for (const NodeId id : plant_.skeleton.ids())
      if (std::ranges::find(subject.sight.nodes, id) == subject.sight.nodes.end())
        hidden_.push_back(id);
    for (const NodeId id : subject.nodes)
      ofNodes[indexOf(id)] = 0;
    const Legend legend{
        .title = {}, .unit = {}, .categories = {{.name = {}, .color = {255, 0, 255}}}};
    scene_.setPointValues(
        PointValues{std::make_shared<const std::vector<float>>(std::move(ofPoints)), legend});
    scene_.setNodeColors(NodeColors{std::move(ofNodes), legend});
  }

  /// The share of the pixels of what is marked that are seen among all else; none: too few pixels.
  [[nodiscard]] std::optional<double> seen(const Camera& camera) {
    auto states = std::make_shared<std::vector<PointState>>(isMeant_.size());
    for (std::size_t i = 0; i < isMeant_.size(); ++i)
      (*states)[i] = isMeant_[i] ? PointState::normal : PointState::hidden;
    scene_.setPointStates(states);
    scene_.skeleton.setHidden(hidden_);
    alone_ = draw(camera);
    scene_.setPointStates(nullptr);
    scene_.skeleton.setHidden({});
    last_ = draw(camera);
    int all = 0;
    int kept = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (isViolet(alone_.pixel(x, y))) {
          ++all;
          kept += isViolet(last_.pixel(x, y)) ? 1 : 0;
        }
    constexpr int fewest = 30; // pixels
    all_ = all;
    return all < fewest ? std::nullopt : std::optional(double(kept) / all);
  }
  [[nodiscard]] const QImage& last() const { return last_; } // with all else

  /// The same of the picture drawn last, less what lies over the plant. Takes the marks off.
  [[nodiscard]] double seenBeside(const Camera& camera) {
    scene_.setPointValues(std::nullopt); // has the color bar of the height
    scene_.setNodeColors(std::nullopt);
    const QSize size(width, height);
    const OnScreen plant = plantOnScreen(scene_, ScreenMap(camera, {width, height}));
    overlay_.giveWay(scene_, plant, size, QFontMetricsF(QApplication::font()));
    map_.giveWay(plant, size, overlay_.corners());
    QImage over(size, QImage::Format_ARGB32_Premultiplied);
    over.fill(Qt::transparent);
    QPainter painter(&over);
    overlay_.paint(painter, scene_, camera, size);
    painter.fillRect(map_.geometry(), Qt::black);
    painter.end();
    int kept = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        kept += isViolet(alone_.pixel(x, y)) && isViolet(last_.pixel(x, y)) &&
                        qAlpha(over.pixel(x, y)) == 0
                    ? 1
                    : 0;
    return double(kept) / all_;
  }

private:
  static bool isViolet(QRgb pixel) {
    const int least = std::min(qRed(pixel), qBlue(pixel));
    return least > 12 && 2 * least > 3 * qGreen(pixel);
  }
  [[nodiscard]] QImage draw(const Camera& camera) {
    PlantRenderer::Frame frame{.camera = camera, .size = {width, height}, .pixelRatio = 1};
    frame.points = std::numeric_limits<Eigen::Index>::max();
    frame.divider = 1;
    while (!renderer_->draw(frame).complete) { // points, then their relief
    }
    return renderer_->image();
  }

  const Plant& plant_;
  Scene scene_;
  Camera first_;
  std::unique_ptr<OffscreenRenderer> renderer_;
  std::vector<bool> isMeant_; // by point
  std::vector<NodeId> hidden_;
  QImage alone_; // what is marked
  QImage last_;  // with all else
  int all_ = 0;  // pixels of what is marked
  QWidget view_;
  Minimap map_{scene_, &view_};
  Overlay overlay_;
};

Camera framed(const Scene& scene, const Camera& now, const Sight& sight) {
  Eigen::AlignedBox3d box;
  for (const NodeId id : sight.nodes)
    box.extend(scene.skeleton.position(indexOf(id)));
  for (const Eigen::Vector3d& place : sight.places)
    box.extend(place);
  box.min().array() -= sight.margin;
  box.max().array() += sight.margin;
  Camera camera = now;
  camera.frame(box, double(width) / height);
  return camera;
}

struct Column {
  const char* name;
  std::vector<double> shares = {};
};

void print(const char* what, std::vector<Column> columns, std::vector<double> times) {
  const auto at = [](std::vector<double>& values, double part) {
    std::ranges::sort(values);
    return values.empty() ? NAN
                          : values[static_cast<std::size_t>(part * double(values.size() - 1))];
  };
  std::printf("%s: %zu\n", what, times.size());
  for (Column& column : columns)
    std::printf("  %-8s median %.3f  worst tenth %.3f  least %.3f\n", column.name,
                at(column.shares, 0.5), at(column.shares, 0.1), at(column.shares, 0));
  std::printf("  choice   median %.1f ms  most %.1f ms\n", at(times, 0.5), at(times, 1));
}

void judge(const char* what, Pictures& pictures, const std::vector<Subject>& subjects,
           const std::string& folder) {
  std::vector<Column> columns{{"framed"}, {"turned"}, {"focused"}, {"beside"}};
  std::vector<double> times;
  Camera now = pictures.first(); // one goes on from where one is
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const Subject& subject = subjects[i];
    const auto begin = std::chrono::steady_clock::now();
    now = cameraToSee(pictures.scene(), now, subject.sight, QSizeF(width, height));
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    times.push_back(took.count());
    pictures.mark(subject);
    const Camera cameras[] = {framed(pictures.scene(), pictures.first(), subject.sight), now, now};
    std::optional<double> focused;
    for (std::size_t c = 0; c < std::size(cameras); ++c) {
      pictures.focusOn(c == 2 ? std::optional(subject.sight) : std::nullopt);
      focused = pictures.seen(cameras[c]);
      if (focused) columns[c].shares.push_back(*focused);
      if (!folder.empty() && i % (1 + subjects.size() / 5) == 0)
        pictures.last().save(QString::fromStdString(folder) +
                             QString("/%1_%2_%3.png").arg(what).arg(i).arg(columns[c].name));
    }
    if (focused) columns.back().shares.push_back(pictures.seenBeside(now));
  }
  print(what, columns, times);
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.size() < 2) {
    std::puts("espalier_sights SCAN STRUCTURE [STOPS [FINDINGS [FOLDER]]]");
    return 2;
  }
  const auto number = [&](std::size_t at, std::size_t usual) {
    return arguments.size() > at ? std::stoul(arguments[at]) : usual;
  };
  const Plant plant = read(arguments[0].c_str(), arguments[1].c_str());
  const std::string folder = arguments.size() > 4 ? arguments[4] : std::string();
  Pictures pictures(plant);
  judge("stops", pictures, stopsOf(plant, number(2, 100)), folder);
  judge("findings", pictures, findingsOf(plant, number(3, 1000)), folder);
  printQuestionSights(plant.cloud, width, height);
  return 0;
}

} // namespace
} // namespace espalier

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication application(argc, argv);
  return espalier::run(std::vector<std::string>(argv + 1, argv + argc));
}
