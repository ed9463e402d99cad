// Pictures of the view, saved by keys in the real window.
#include "tests/app/window/window_fixture.h"
#include "ui/view/plant_view.h"

#include <QFileDialog>
#include <QImage>
#include <QSpinBox>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

namespace espalier {
namespace {

class PictureTest : public test::WindowTest {
protected:
  void save(const QString& file) {
    answer(
        [&](QDialog& dialog) {
          proposed_ = dynamic_cast<QFileDialog&>(dialog).selectedFiles();
          chooseFile(file)(dialog);
        },
        [this] { key(Qt::Key_P, Qt::ControlModifier | Qt::AltModifier); });
  }

  QStringList proposed_;
};

TEST_F(PictureTest, IsWhatTheViewShows) {
  EXPECT_FALSE(action("save_picture").isEnabled()) << "there is nothing to see";
  open({writeFork("fork.mtg")});
  save(path("seen.png"));
  EXPECT_EQ(proposed_, QStringList(path("fork.png")));
  const QImage picture(path("seen.png"));
  const double pixelRatio = 2 * view().devicePixelRatio();
  const QSize size = view().size() * pixelRatio;
  EXPECT_EQ(picture.size(), size);
  EXPECT_EQ(picture.convertToFormat(QImage::Format_RGB32),
            view().picture(size, pixelRatio).convertToFormat(QImage::Format_RGB32));
}

TEST_F(PictureTest, HasTextsAsLargeAsTheViewHas) {
  open({writeFork("fork.mtg")});
  save(path("seen.png"));
  const QSize size = view().size() * 2 * view().devicePixelRatio();
  EXPECT_NE(QImage(path("seen.png")).convertToFormat(QImage::Format_RGB32),
            view().picture(size).convertToFormat(QImage::Format_RGB32))
      << "drawn for a screen of that many pixels, all is half as large";
}

TEST_F(PictureTest, TurnsAsAMovie) {
  EXPECT_FALSE(action("save_turntable").isEnabled()) << "there is nothing to see";
  open({writeFork("fork.mtg")});
  const auto save = [this](const QString& file) {
    answer(
        [&](QDialog& dialog) {
          dialog.findChild<QSpinBox*>("turntable_width")->setValue(200);
          dialog.findChild<QSpinBox*>("turntable_seconds")->setValue(2);
          QTimer::singleShot(0,
                             [this, file] { answer(chooseFile(file), [] { QTest::qWait(1); }); });
          press("Choose File")(dialog);
        },
        [this] { action("save_turntable").trigger(); });
  };
  save(path("turn.png"));
  ASSERT_TRUE(window().jobs().isBusy());
  waitForJob();
  EXPECT_TRUE(window().banner().text().startsWith("Wrote turn.png: 30 pictures"))
      << window().banner().text().toStdString();
  EXPECT_EQ(QImage(path("turn.png")).width(), 200);
  save(path("stopped.png"));
  clickButton("cancel_job");
  waitForJob();
  EXPECT_FALSE(QFile::exists(path("stopped.png"))) << "nothing is left behind";
  save(path("turn.gif"));
  EXPECT_TRUE(window().banner().text().contains("choose a name that ends in .png"));
}

TEST_F(PictureTest, OfAnotherFormatIsRefused) {
  open({writeFork("fork.mtg")});
  save(path("seen.gif"));
  EXPECT_FALSE(QFile::exists(path("seen.gif")));
  EXPECT_TRUE(window().banner().text().contains("choose a name that ends in .png"));
}

} // namespace
} // namespace espalier
