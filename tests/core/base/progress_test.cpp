#include "core/base/progress.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <string>
#include <vector>

namespace espalier {
namespace {

using testing::ElementsAre;

TEST(Progress, ThrowsCancelledOnceAStopIsAskedFor) {
  std::stop_source source;
  const Progress progress(source.get_token(), {});
  EXPECT_NO_THROW(progress.update(0.5));
  source.request_stop();
  EXPECT_THROW(progress.update(0.6), Cancelled);
  EXPECT_THROW(progress.check(), Cancelled);
}

TEST(Progress, MapsPartsIntoTheWhole) {
  std::vector<std::pair<double, std::string>> reports;
  const Progress progress(
      {}, [&](double fraction, std::string_view stage) { reports.emplace_back(fraction, stage); });
  progress.part(0.2, 0.6, "first").part(0.5, 1).update(0.5);
  progress.part(0.6, 1, "second").update(0);
  EXPECT_THAT(reports, ElementsAre(testing::Pair(testing::DoubleEq(0.5), "first"),
                                   testing::Pair(testing::DoubleEq(0.6), "second")));
}

TEST(Progress, NeverGoesBack) {
  std::vector<double> reports;
  const Progress progress({},
                          [&](double fraction, std::string_view) { reports.push_back(fraction); });
  for (const double fraction : {0.1, 0.5, 0.3, 0.7})
    progress.update(fraction);
  EXPECT_THAT(reports, ElementsAre(0.1, 0.5, 0.7));
}

TEST(Progress, ReportsSparingly) {
  int reports = 0;
  const Progress progress({}, [&](double, std::string_view) { ++reports; });
  for (int i = 0; i <= 1000000; ++i)
    progress.update(i / 1e6);
  EXPECT_LE(reports, 300);
  EXPECT_GE(reports, 100);
}

TEST(Progress, MadeByDefaultReportsToNobody) {
  EXPECT_NO_THROW(Progress().part(0, 0.5, "stage").update(1));
}

} // namespace
} // namespace espalier
