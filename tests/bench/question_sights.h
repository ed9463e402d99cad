#pragma once

#include "core/cloud/point_cloud.h"

#include <memory>

namespace espalier {

/// Prints of the questions about a reconstruction by default, each in the view that is chosen for
/// it, the median and the worst tenth of two lengths [logical pixels], and of how many questions
/// they are too small: how long the shortest line of an answer is that neither another answer nor a
/// number covers ("free"), and how far the lines of two answers lie apart where they do most, of
/// the two that do least ("apart").
void printQuestionSights(const std::shared_ptr<const PointCloud>& cloud, int width, int height);

} // namespace espalier
