// What is shown and asked of a scan before it is read.
#include "core/io/formats.h"
#include "tests/app/window/project_fixture.h"
#include "tests/support/shared_data.h"
#include "ui/dialogs/count_box.h"
#include "ui/panels/status_line.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QTableWidget>
#include <QTest>
#include <QTimer>

#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::HasSubstr;

struct ImportTest : test::ProjectWindowTest {
  using Reply = std::function<void(QDialog&)>;

  QString write(const QString& name, const std::string& text) {
    std::ofstream(path(name).toStdString(), std::ios::binary) << text;
    return path(name);
  }
  /// Columns are height, y, x and a number of the leaf, named otherwise than x, y and z.
  QString writeField(const QString& name) {
    std::string text = "height north east leaf\n";
    for (int i = 0; i < 200; ++i)
      text += std::to_string(0.01 * i) + " 0.2 " + std::to_string(0.001 * (i % 7)) + " 5\n";
    return write(name, text);
  }
  /// Opens files as a drop does, answers what is asked, and waits until all is there.
  void openAnd(const QString& file, const Reply& reply) {
    answer(reply, [&] {
      window().open({file});
      waitForJob();
    });
    waitForJob();
  }
  /// The same by the command that asks in any case.
  void openWithChoices(const QString& file, const Reply& reply) {
    int shown = 0;
    answer(
        [&](QDialog& dialog) {
          ASSERT_EQ(++shown, 1);
          QTimer::singleShot(0, [&, this] { answerNext(reply); });
          chooseFile(file)(dialog);
        },
        [&] {
          action("open_with_choices").trigger();
          waitForJob();
        });
    waitForJob();
    EXPECT_TRUE(isAnswered_) << "it was not asked";
  }
  /// Answers the page that is shown after another dialog.
  void next(const Reply& reply) {
    tries_ = 0;
    const QPointer<QWidget> before = QApplication::activeModalWidget();
    QTimer::singleShot(0, &window(), [this, before, reply] { answerAfter(before, reply); });
  }
  static QString textOfLabel(const QDialog& dialog, const char* name) {
    const auto* label = dialog.findChild<QLabel*>(name);
    EXPECT_NE(label, nullptr) << name;
    return label != nullptr && !label->isHidden() ? label->text() : QString();
  }
  static QComboBox& list(const QDialog& dialog, const QString& name) {
    return *dialog.findChild<QComboBox*>(name);
  }
  /// Chooses from a list by keys, as a hand does.
  static void choose(QDialog& dialog, const QString& name, const QString& text) {
    QComboBox& box = list(dialog, name);
    const int row = box.findText(text);
    ASSERT_GE(row, 0) << text.toStdString();
    box.setFocus();
    while (box.currentIndex() != row)
      QTest::keyClick(&box, box.currentIndex() < row ? Qt::Key_Down : Qt::Key_Up);
  }
  static QPushButton& openButton(const QDialog& dialog) {
    return *dialog.findChild<QPushButton*>("open_chosen");
  }
  [[nodiscard]] const PointCloud& cloud() { return *document().scan()->cloud(); }

private:
  void answerNext(const Reply& reply) {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr || dialog->objectName() != "open_scan") {
      if (++tries_ < 5000) QTimer::singleShot(2, [&, this] { answerNext(reply); });
      return;
    }
    isAnswered_ = true;
    reply(*dialog);
  }
  void answerAfter(const QPointer<QWidget>& before, const Reply& reply) {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog != nullptr && dialog != before && dialog->objectName() == "open_scan")
      return reply(*dialog);
    if (++tries_ < 5000)
      QTimer::singleShot(2, &window(), [this, before, reply] { answerAfter(before, reply); });
    else
      ADD_FAILURE() << "no page was shown";
  }
  bool isAnswered_ = false;
  int tries_ = 0;
};

TEST_F(ImportTest, AScanThatIsClearIsOpenedWithoutAQuestion) {
  expectNoDialog([this] { open({writeScan("plant.xyz")}); });
  EXPECT_NE(document().scan(), nullptr);
}

TEST_F(ImportTest, ShowsWhatIsInAFileBeforeItIsRead) {
  openWithChoices(write("oak.xyz", "0 0 0 7 10 20 30\n1 0.5 2 8 40 50 60\n"), [](QDialog& dialog) {
    EXPECT_EQ(textOfLabel(dialog, "scan_name"), "oak.xyz");
    EXPECT_THAT(textOfLabel(dialog, "scan_format").toStdString(), HasSubstr("parted by blanks"));
    EXPECT_THAT(textOfLabel(dialog, "scan_points").toStdString(), HasSubstr("2, with"));
    EXPECT_THAT(textOfLabel(dialog, "scan_bounds").toStdString(), HasSubstr("y from 0 to 0.5"));
    EXPECT_THAT(textOfLabel(dialog, "scan_size").toStdString(), HasSubstr("1.00 × 0.500 × 2.00"));
    EXPECT_EQ(list(dialog, "scan_unit").currentText(), "m");
    EXPECT_TRUE(textOfLabel(dialog, "unit_reason").startsWith("Guessed: "));
    EXPECT_TRUE(textOfLabel(dialog, "up_reason").startsWith("Guessed: "));
    dialog.reject();
  });
  EXPECT_EQ(document().scan(), nullptr);
}

TEST_F(ImportTest, AsksForColumnsThatCannotBeFoundOut) {
  openAnd(writeField("field.txt"), [](QDialog& dialog) {
    EXPECT_THAT(textOfLabel(dialog, "scan_questions").toStdString(),
                HasSubstr("The first line names the columns"));
    EXPECT_EQ(dialog.focusWidget(), &list(dialog, "column_1")) << "where the question is";
    choose(dialog, "column_1", "z");
    EXPECT_EQ(textOfLabel(dialog, "scan_problem"),
              "No column holds x: choose it above one of them.");
    EXPECT_FALSE(openButton(dialog).isEnabled());
    choose(dialog, "column_3", "x");
    EXPECT_EQ(textOfLabel(dialog, "scan_problem"), "");
    choose(dialog, "column_4", "left out");
    QTest::keyClick(&dialog, Qt::Key_Return);
  });
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_NEAR(cloud().bounds().max().z(), 1.99, 1e-4);
  EXPECT_NEAR(cloud().bounds().max().x(), 0.006, 1e-6);
  EXPECT_TRUE(cloud().intensities().empty());
}

TEST_F(ImportTest, AQuestionGoesOnceItIsAnswered) {
  openAnd(writeField("field.txt"), [](QDialog& dialog) {
    const auto& questions = *dialog.findChild<QLabel*>("scan_questions");
    const int height = dialog.findChild<QComboBox*>("scan_unit")->y();
    choose(dialog, "column_1", "z");
    EXPECT_TRUE(questions.isVisible()) << "no column holds x";
    choose(dialog, "column_3", "x");
    EXPECT_FALSE(questions.isVisible());
    EXPECT_EQ(dialog.findChild<QComboBox*>("scan_unit")->y(), height) << "nothing moves";
    dialog.reject();
  });
}

TEST_F(ImportTest, BadChoicesAreSaidAtOnce) {
  openAnd(writeField("field.txt"), [](QDialog& dialog) {
    choose(dialog, "column_4", "x");
    EXPECT_EQ(textOfLabel(dialog, "scan_problem"),
              "Two columns hold x: choose something else above one of them.");
    choose(dialog, "column_4", "red");
    EXPECT_EQ(textOfLabel(dialog, "scan_problem"),
              "A color is red, green and blue: choose all three, or none of them.");
    QTest::keyClick(&dialog, Qt::Key_Return);
    EXPECT_TRUE(dialog.isVisible()) << "it cannot be opened so";
    QTest::keyClick(&dialog, Qt::Key_Escape);
  });
  EXPECT_EQ(document().scan(), nullptr);
}

TEST_F(ImportTest, ALineWithTooFewValuesIsMarked) {
  openAnd(write("short.xyz", "1 2 3 4\n2 3 4\n4 5 6 7\n"), [](QDialog& dialog) {
    EXPECT_THAT(textOfLabel(dialog, "scan_questions").toStdString(),
                HasSubstr("Some lines cannot be read"));
    const auto& table = *dialog.findChild<QTableWidget*>("columns");
    EXPECT_EQ(table.verticalHeaderItem(0)->text(), "1");
    EXPECT_EQ(table.verticalHeaderItem(1)->text(), "✗ 2");
    EXPECT_TRUE(table.item(1, 0)->font().strikeOut());
    EXPECT_THAT(textOfLabel(dialog, "scan_problem").toStdString(),
                HasSubstr("Line 2 has 3 values, too few for these columns"));
    EXPECT_FALSE(openButton(dialog).isEnabled());
    choose(dialog, "column_4", "left out");
    EXPECT_EQ(table.verticalHeaderItem(1)->text(), "2");
    QTest::mouseClick(&openButton(dialog), Qt::LeftButton);
  });
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(cloud().size(), 3);
}

TEST_F(ImportTest, WhatIsShownFollowsTheColumns) {
  openAnd(writeField("field.txt"), [](QDialog& dialog) {
    choose(dialog, "column_1", "z");
    choose(dialog, "column_3", "x");
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return textOfLabel(dialog, "scan_bounds").contains("z from 0 to 1.99"); }, patience))
        << textOfLabel(dialog, "scan_bounds").toStdString();
    dialog.reject();
  });
}

TEST_F(ImportTest, FilesWithTheSameFirstLineAreReadAlike) {
  const auto name = [](QDialog& dialog) {
    choose(dialog, "column_1", "z");
    choose(dialog, "column_3", "x");
    choose(dialog, "column_4", "left out");
    QTest::keyClick(&dialog, Qt::Key_Return);
  };
  openAnd(writeField("field.txt"), name);
  action("close_plant").trigger();
  const QString other = writeField("other.txt");
  expectNoDialog([&] { open({other}); });
  EXPECT_THAT(message().toStdString(), HasSubstr("read as you named them before"));
  EXPECT_EQ(document().scanPath(), other);
  EXPECT_NEAR(cloud().bounds().max().z(), 1.99, 1e-4);
}

TEST_F(ImportTest, ColumnsThatWereNamedAreKnownToTheNextSessionUntilTheyAreDropped) {
  const auto name = [](QDialog& dialog) {
    choose(dialog, "column_1", "z");
    choose(dialog, "column_3", "x");
    choose(dialog, "column_4", "left out");
    QTest::mouseClick(&openButton(dialog), Qt::LeftButton);
  };
  const QString file = writeField("field.txt");
  openAnd(file, name);
  ASSERT_NE(document().scan(), nullptr);
  window().close();
  restart();
  expectNoDialog([&] { open({file}); });
  EXPECT_THAT(message().toStdString(), HasSubstr("read as you named them before"));
  EXPECT_NEAR(cloud().bounds().max().z(), 1.99, 1e-4);
  openWithChoices(file, [](QDialog& dialog) {
    EXPECT_EQ(list(dialog, "column_1").currentText(), "z") << "as they were named";
    auto& remembers = *dialog.findChild<QCheckBox*>("remember_columns");
    EXPECT_TRUE(remembers.isChecked());
    remembers.setChecked(false);
    QTest::mouseClick(&openButton(dialog), Qt::LeftButton);
  });
  window().close();
  restart();
  openAnd(file, [](QDialog& dialog) {
    EXPECT_THAT(textOfLabel(dialog, "scan_questions").toStdString(), HasSubstr("none x, y and z"));
    dialog.reject();
  });
}

TEST_F(ImportTest, WhatSettingsHoldThatAreNoColumnsIsPassedOver) {
  for (const char* kept : {"{", "[1, 2]", R"({"height north east leaf": "x y"})",
                           R"({"height north east leaf": 7})"}) {
    QSettings(path("settings.ini"), QSettings::IniFormat).setValue("files/named_columns", kept);
    restart();
    openAnd(writeField("field.txt"), [](QDialog& dialog) {
      EXPECT_THAT(textOfLabel(dialog, "scan_questions").toStdString(),
                  HasSubstr("none x, y and z"));
      dialog.reject();
    });
  }
}

// Beyond the lines that the page shows.
TEST_F(ImportTest, ALineThatCannotBeReadIsShownInThePageWithWhatWasChosen) {
  std::string text = "height north east leaf\n";
  for (int i = 0; i < 200; ++i)
    text += i == 150 ? "0.5 0.2\n" : std::to_string(0.01 * i) + " 0.2 0.1 5\n";
  const QString file = write("long.txt", text);
  openAnd(file, [&](QDialog& first) {
    choose(first, "column_1", "z");
    choose(first, "column_3", "x");
    choose(first, "column_4", "left out");
    choose(first, "scan_unit", "cm");
    choose(first, "scan_up", "y");
    next([&](QDialog& again) {
      EXPECT_THAT(textOfLabel(again, "scan_problem").toStdString(),
                  HasSubstr("long.txt, line 152"));
      EXPECT_EQ(list(again, "column_1").currentText(), "z");
      EXPECT_EQ(list(again, "column_4").currentText(), "left out");
      EXPECT_EQ(list(again, "scan_unit").currentText(), "cm");
      EXPECT_EQ(list(again, "scan_up").currentText(), "y");
      EXPECT_TRUE(openButton(again).isEnabled()) << "the file may be mended meanwhile";
      text.replace(text.find("0.5 0.2\n"), 8, "0.5 0.2 0.1 5\n");
      write("long.txt", text);
      QTest::mouseClick(&openButton(again), Qt::LeftButton);
    });
    QTest::mouseClick(&openButton(first), Qt::LeftButton);
  });
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(cloud().size(), 200);
  EXPECT_EQ(document().unit(), LengthUnit::centimeter);
  EXPECT_EQ(document().up(), UpAxis::y);
}

TEST_F(ImportTest, ATextThatIsOpenedUnaskedAndCannotBeReadShowsWhyInThePage) {
  open({writeScan("plant.xyz")});
  const auto before = document().scan()->cloud();
  std::string text = "x y z\n";
  for (int i = 0; i < 60; ++i)
    text += i == 50 ? "1 2 none\n" : "1 2 " + std::to_string(0.01 * i) + "\n";
  const QString file = write("bad.xyz", text);
  next([&](QDialog& page) {
    EXPECT_THAT(textOfLabel(page, "scan_problem").toStdString(), HasSubstr("bad.xyz, line 52"));
    page.reject();
  });
  openAnd(file, press("Open"));
  EXPECT_EQ(document().scan()->cloud(), before) << "nothing has changed";
}

TEST_F(ImportTest, AProjectKnowsTheColumns) {
  openAnd(writeField("field.txt"), [](QDialog& dialog) {
    choose(dialog, "column_1", "z");
    choose(dialog, "column_3", "x");
    choose(dialog, "column_4", "left out");
    QTest::keyClick(&dialog, Qt::Key_Return);
  });
  const QString file = saveProject("field.espalier");
  const Eigen::Matrix3Xf points = cloud().positions();
  window().close();
  restart();
  expectNoDialog([&] { open({file}); });
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(cloud().positions(), points);
  EXPECT_FALSE(action("read_region").isEnabled()) << "it is whole";
}

TEST_F(ImportTest, UnitAndUpAreTakenIntoThePlant) {
  openWithChoices(writeScan("plant.xyz"), [](QDialog& dialog) {
    choose(dialog, "scan_unit", "cm");
    choose(dialog, "scan_up", "y");
    EXPECT_THAT(textOfLabel(dialog, "scan_size").toStdString(), HasSubstr("cm, which is"));
    QTest::mouseClick(&openButton(dialog), Qt::LeftButton);
  });
  EXPECT_EQ(document().unit(), LengthUnit::centimeter);
  EXPECT_EQ(document().up(), UpAxis::y);
  EXPECT_TRUE(action("up_y").isChecked());
  action("close_plant").trigger();
  open({writeScan("next.xyz")});
  EXPECT_EQ(document().unit(), LengthUnit::meter) << "the next plant is as it seems";
  EXPECT_EQ(document().up(), UpAxis::z);
}

TEST_F(ImportTest, ASampleOrABoxCanBeRead) {
  const QString scan = writeScan("plant.xyz");
  const PointCloud whole = readPoints(toPath(scan)).value;
  openWithChoices(scan, [&](QDialog& dialog) {
    EXPECT_TRUE(dialog.findChild<QRadioButton*>("read_all")->isChecked());
    EXPECT_THAT(textOfLabel(dialog, "all_text").toStdString(), HasSubstr("of memory"));
    auto& most = *dialog.findChild<CountBox*>("read_most");
    most.setFocus();
    most.selectAll();
    QTest::keyClicks(&most, "1 000");
    EXPECT_TRUE(dialog.findChild<QRadioButton*>("read_some")->isChecked()) << "it was typed";
    QTest::mouseClick(dialog.findChild<QCheckBox*>("read_box"), Qt::LeftButton);
    dialog.findChild<QDoubleSpinBox*>("box_z_to")->setValue(-5);
    EXPECT_THAT(textOfLabel(dialog, "scan_problem").toStdString(), HasSubstr("empty along z"));
    dialog.findChild<QDoubleSpinBox*>("box_z_to")->setValue(1);
    EXPECT_EQ(textOfLabel(dialog, "scan_problem"), "");
    QTest::mouseClick(&openButton(dialog), Qt::LeftButton);
  });
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(cloud().size(), 1000);
  EXPECT_LE(cloud().bounds().max().z(), 1);
  EXPECT_TRUE(window().statusLine().counts().contains("part of "));
}

TEST_F(ImportTest, TheLimitOfWhatIsReadWithoutAskingIsSetThere) {
  const QString scan = writeScan("plant.xyz");
  openWithChoices(scan, [&](QDialog& dialog) {
    auto& limit = *dialog.findChild<CountBox*>("most_at_once");
    EXPECT_EQ(limit.value(), 20'000'000);
    limit.setValue(500);
    QTest::mouseClick(&openButton(dialog), Qt::LeftButton);
  });
  EXPECT_GT(cloud().size(), 500) << "all of it was asked for";
  action("close_plant").trigger();
  openAnd(scan, [](QDialog& dialog) {
    EXPECT_THAT(textOfLabel(dialog, "scan_questions").toStdString(),
                HasSubstr("more than are read without asking"));
    EXPECT_TRUE(dialog.findChild<QRadioButton*>("read_some")->isChecked());
    QTest::keyClick(&dialog, Qt::Key_Return);
  });
  EXPECT_EQ(cloud().size(), 500);
}

TEST_F(ImportTest, CancelLeavesThePlantAsItWas) {
  open({writeScan("plant.xyz")});
  const auto before = document().scan()->cloud();
  openWithChoices(writeField("field.txt"), [](QDialog& dialog) {
    choose(dialog, "scan_unit", "cm");
    dialog.findChild<CountBox*>("most_at_once")->setValue(5);
    QTest::keyClick(&dialog, Qt::Key_Escape);
  });
  EXPECT_EQ(document().scan()->cloud(), before);
  EXPECT_EQ(document().unit(), LengthUnit::meter);
  EXPECT_TRUE(window().statusLine().shownText().contains("nothing has changed"));
  EXPECT_FALSE(
      QSettings(path("settings.ini"), QSettings::IniFormat).contains("most_points_at_once"));
}

TEST_F(ImportTest, TheKeysGoDownThePageAndAlongTheColumns) {
  openAnd(writeField("field.txt"), [](QDialog& dialog) {
    QStringList names;
    QApplication::setActiveWindow(&dialog);
    list(dialog, "scan_unit").setFocus();
    for (int i = 0; i < 30 && names.count("scan_unit") < 2; ++i) {
      names.append(QApplication::focusWidget()->objectName());
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    const QStringList expected = {"scan_unit",  "scan_up",  "read_all",         "read_most",
                                  "read_box",   "column_1", "column_2",         "column_3",
                                  "column_4",   "columns",  "remember_columns", "most_at_once",
                                  "open_chosen"};
    EXPECT_EQ(names.mid(0, expected.size()), expected) << names.join(' ').toStdString();
    dialog.reject();
  });
}

TEST_F(ImportTest, WhatIsNoScanIsRefusedInALine) {
  std::string noise(4000, '\0');
  for (std::size_t i = 0; i < noise.size(); ++i)
    noise[i] = static_cast<char>(i * 37 % 251);
  const std::vector<std::pair<QString, std::string>> files = {
      {write("empty.xyz", ""), "is empty"},
      {write("binary.xyz", noise), "is no plain text"},
      {write("two.xyz", "1 2\n3 4\n"), "has 2 columns"},
      {write("broken.laz", "LASF and no more"), "broken.laz"},
      {path("missing.xyz"), "there is no such file"}};
  for (const auto& [file, reason] : files) {
    expectNoDialog([&, file = file] { open({file}); });
    EXPECT_THAT(message().toStdString(), HasSubstr(reason));
    EXPECT_FALSE(message().contains('\n'));
    EXPECT_EQ(document().scan(), nullptr);
  }
}

TEST_F(ImportTest, WhatIsNoScanLeavesThePlantAsItWas) {
  open({writeScan("plant.xyz")});
  const auto before = document().scan()->cloud();
  openAnd(write("two.xyz", "1 2\n3 4\n"), press("Open"));
  EXPECT_THAT(message().toStdString(), HasSubstr("has 2 columns"));
  EXPECT_EQ(document().scan()->cloud(), before);
}

TEST_F(ImportTest, AStructureIsOpenedWithoutAQuestionInAnyCase) {
  const QString fork = writeFork("fork.mtg");
  answer(chooseFile(fork), [this] {
    action("open_with_choices").trigger();
    waitForJob();
  });
  EXPECT_FALSE(document().skeleton().isEmpty());
}

TEST_F(ImportTest, WhatTheFileStatesIsNoGuess) {
  ESPALIER_SHARED_FILE(file, "e57/bunnyDouble.e57");
  openWithChoices(QString::fromStdString(file.string()), [](QDialog& dialog) {
    EXPECT_EQ(dialog.findChild<QTableWidget*>("columns"), nullptr) << "it names its own";
    EXPECT_THAT(textOfLabel(dialog, "scan_columns").toStdString(), HasSubstr("cartesianX"));
    EXPECT_TRUE(textOfLabel(dialog, "unit_reason").startsWith("Stated: "));
    QTest::keyClick(&dialog, Qt::Key_Return);
  });
  ASSERT_NE(document().scan(), nullptr);
  EXPECT_EQ(document().unit(), LengthUnit::meter);
}

} // namespace
} // namespace espalier
