#include "ui/panels/elided_label.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QToolTip>
#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(ElidedLabel, ShowsATipThatSaysTheSameOnlyWhereItIsCut) {
  ElidedLabel label;
  label.setText("Drag: turn   Wheel: zoom");
  label.setToolTip(label.text());
  label.show();
  const auto tipAtWidth = [&](int width) {
    label.resize(width, 20);
    QHelpEvent asked(QEvent::ToolTip, {1, 1}, label.mapToGlobal(QPoint(1, 1)));
    QCoreApplication::sendEvent(&label, &asked);
    return QToolTip::text();
  };
  EXPECT_EQ(tipAtWidth(600), QString());
  EXPECT_EQ(tipAtWidth(40), label.text());
  label.setToolTip("What the mouse does");
  EXPECT_EQ(tipAtWidth(600), "What the mouse does");
  QToolTip::hideText();
}

} // namespace
} // namespace espalier
