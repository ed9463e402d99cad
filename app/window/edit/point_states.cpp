#include "app/window/edit/point_states.h"

#include "ui/document/plant_document.h"
#include "ui/view/plant_view.h"

#include <utility>

namespace espalier {

PointStates::PointStates(PlantDocument& document, PlantView& view)
    : document_(document), view_(view) {
  timer_.setSingleShot(true);
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &PointStates::show);
  for (auto signal : {&PlantDocument::leftOutChanged, &PlantDocument::scanChanged})
    connect(&document, signal, &timer_, qOverload<>(&QTimer::start));
  connect(&document.pointSelection(), &PointSelection::changed, &timer_,
          qOverload<>(&QTimer::start));
  connect(&document, &PlantDocument::scanChanged, this, [this] {
    explained_.reset();
    isolated_.reset();
    hidden_ = {};
    hasStates_ = false; // the view forgets them
  });
}

void PointStates::setExplained(std::shared_ptr<const std::vector<PointState>> states) {
  explained_ = std::move(states);
  show(); // who sets them has waited already
}

void PointStates::showAside(bool areShown) {
  isAsideShown_ = areShown;
  timer_.start();
}

void PointStates::isolate(std::optional<PointSet> points) {
  isolated_ = std::move(points);
  timer_.start();
}

void PointStates::hide(PointSet points) {
  if (points == hidden_) return;
  hidden_ = std::move(points);
  timer_.start();
}

void PointStates::show() {
  auto all = states();
  const bool isPlain = all == nullptr;
  if (!isPlain || hasStates_) view_.setPointStates(std::move(all));
  hasStates_ = !isPlain;
}

std::shared_ptr<const std::vector<PointState>> PointStates::states() const {
  const PointSet& leftOut = document_.leftOut();
  const PointSet& selected = document_.pointSelection().points();
  const bool isPlain = leftOut.isEmpty() && selected.isEmpty() && hidden_.isEmpty() && !isolated_;
  if (document_.scan() == nullptr || isPlain) return explained_;
  const Eigen::Index count = document_.scan()->cloud()->size();
  const PointSet all = PointSet::firstOf(count);
  auto result = explained_ ? std::make_shared<std::vector<PointState>>(*explained_)
                           : std::make_shared<std::vector<PointState>>(
                                 static_cast<std::size_t>(count), PointState::normal);
  const auto set = [&](const PointSet& points, PointState state) {
    for (const Eigen::Index point : (points & all).points())
      (*result)[static_cast<std::size_t>(point)] = state;
  };
  set(leftOut, isAsideShown_ ? PointState::aside : PointState::hidden);
  set(selected, PointState::selected);
  set(hidden_, PointState::hidden);
  if (isolated_) set(all - *isolated_, PointState::hidden);
  return result;
}

} // namespace espalier
