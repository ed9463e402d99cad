#include "tests/bench/question_sights.h"

#include "app/window/review/doubt_ghosts.h"
#include "core/doubt/doubts_of.h"
#include "core/pipeline/pipeline.h"
#include "ui/view/close_look.h"
#include "ui/view/ghost_overlay.h"
#include "ui/view/picture.h"
#include "ui/view/scene.h"

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <vector>

namespace espalier {
namespace {

/// The lengths of the lines of answers in the view of a question that nothing of it covers.
std::vector<double> freeLengths(const std::vector<ShownGhost>& ghosts, const Camera& camera,
                                const QSize& size) {
  const ScreenMap screen(camera, {size.width(), size.height()});
  QImage picture(size, QImage::Format_RGB32);
  picture.fill(Qt::black);
  {
    QPainter painter(&picture);
    paintGhosts(painter, ghosts, screen, false);
    painter.setPen(QPen(Qt::black, 2));
    painter.setBrush(Qt::black);
    for (const GhostNumber& number : numbersOf(ghosts, screen)) {
      painter.drawLine(number.at, number.of);
      painter.drawEllipse(number.at, GhostNumber::radius, GhostNumber::radius);
    }
  }
  std::vector<double> lengths;
  for (const ShownGhost& ghost : ghosts) {
    if (ghost.number == 0 || ghost.look == ShownGhost::Look::removed || ghost.lines.empty())
      continue;
    const Color color = colorOfGhost(ghost.number, false);
    int pixels = 0;
    for (int y = 0; y < size.height(); ++y)
      for (int x = 0; x < size.width(); ++x)
        pixels += picture.pixel(x, y) == qRgb(color[0], color[1], color[2]) ? 1 : 0;
    constexpr double across = 4; // pixels
    lengths.push_back(pixels / across / (ghost.look == ShownGhost::Look::proposed ? 0.67 : 1));
  }
  return lengths;
}

/// How far the lines of two answers lie apart in the view of a question, where they do most: of the
/// two answers that do least [pixels]; none if there are less.
std::optional<double> leastApart(const std::vector<ShownGhost>& ghosts, const Camera& camera,
                                 const QSize& size) {
  const ScreenMap screen(camera, {size.width(), size.height()});
  constexpr int steps = 20; // an edge is looked at in
  std::vector<std::vector<Eigen::Vector2d>> answers;
  for (const ShownGhost& ghost : ghosts) {
    if (ghost.number == 0 || ghost.look == ShownGhost::Look::removed) continue;
    std::vector<Eigen::Vector2d> places;
    for (const std::vector<Eigen::Vector3d>& line : ghost.lines)
      for (std::size_t i = 1; i < line.size(); ++i)
        for (int step = 0; step <= steps; ++step)
          if (const auto at = screen.project(line[i - 1] + (line[i] - line[i - 1]) * step / steps))
            places.push_back(at->pixel);
    if (!places.empty()) answers.push_back(std::move(places));
  }
  const auto farthest = [](const auto& from, const auto& to) {
    double most = 0;
    for (const Eigen::Vector2d& a : from) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Eigen::Vector2d& b : to)
        nearest = std::min(nearest, (a - b).norm());
      most = std::max(most, nearest);
    }
    return most;
  };
  std::optional<double> least;
  for (std::size_t a = 0; a < answers.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const double apart =
          std::max(farthest(answers[a], answers[b]), farthest(answers[b], answers[a]));
      least = std::min(apart, least.value_or(apart));
    }
  return least;
}

void printLeast(const char* what, std::vector<double> values, double few) {
  std::ranges::sort(values);
  const auto at = [&](double part) {
    return values.empty() ? NAN
                          : values[static_cast<std::size_t>(part * double(values.size() - 1))];
  };
  const auto under = std::ranges::lower_bound(values, few) - values.begin();
  std::printf("  %-8s median %.1f  worst tenth %.1f  least %.1f  under %.0f: %.3f\n", what, at(0.5),
              at(0.1), at(0), few, double(under) / double(values.size()));
}

} // namespace

void printQuestionSights(const std::shared_ptr<const PointCloud>& cloud, int width, int height) {
  const QSize size(width, height);
  const Reconstruction result = Pipeline().run(cloud, {});
  Scene scene;
  scene.setCloud(cloud);
  scene.setSkeleton(*result.skeleton);
  Camera now = cameraOf(scene, StandardView::front, double(width) / height);
  std::vector<double> least;
  std::vector<double> apart;
  const std::vector<Doubt> doubts = doubtsOf(cloud, result, UpAxis::z).doubts;
  for (const Doubt& doubt : doubts) {
    const std::vector<ShownGhost> ghosts = ghostsOf(*result.skeleton, doubt);
    now = cameraToSee(scene, now, sightOf(*result.skeleton, doubt), QSizeF(size));
    if (const std::vector<double> lengths = freeLengths(ghosts, now, size); !lengths.empty())
      least.push_back(std::ranges::min(lengths));
    if (const auto one = leastApart(ghosts, now, size)) apart.push_back(*one);
  }
  std::printf("questions: %zu\n", doubts.size());
  printLeast("free", least, 10);
  printLeast("apart", apart, 20);
}

} // namespace espalier
