#include "app/about/libraries.h"
#include "app/about/version.h"
#include "tests/app/window/window_fixture.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class AboutTest : public test::WindowTest {
protected:
  AboutTest() { action("about").trigger(); }
};

TEST_F(AboutTest, ShowsTheVersionAndTheLicense) {
  EXPECT_THAT(find<QLabel>("about_text").text().toStdString(), HasSubstr(programVersion()));
  const std::string license = find<QPlainTextEdit>("about_license").toPlainText().toStdString();
  for (const char* notice : {"Permission is hereby granted", "Marius Muja", "Niels Lohmann",
                             "University of Cincinnati", "Redistributions in binary form"})
    EXPECT_THAT(license, HasSubstr(notice)) << "of what is compiled in";
}

TEST_F(AboutTest, ListsEachLibraryWithItsVersionAndLicense) {
  const auto& table = find<QTableWidget>("about_libraries");
  ASSERT_EQ(table.rowCount(), static_cast<int>(libraries().size()));
  for (int row = 0; row < table.rowCount(); ++row) {
    SCOPED_TRACE(table.item(row, 0)->text().toStdString());
    EXPECT_THAT(table.item(row, 1)->text().toStdString(), MatchesRegex("[0-9]+(.[0-9]+)+"));
    EXPECT_FALSE(table.item(row, 2)->text().isEmpty());
    EXPECT_FALSE(table.item(row, 3)->text().isEmpty());
  }
  EXPECT_EQ(table.item(0, 0)->text(), "Qt");
  EXPECT_EQ(table.item(0, 1)->text(), qVersion());
}

TEST_F(AboutTest, CopiesTheVersionsForAReportOfAProblem) {
  find<QPushButton>("about_copy").click();
  const std::string text = QGuiApplication::clipboard()->text().toStdString();
  EXPECT_THAT(text, testing::StartsWith("Espalier " + programVersion() + '\n'));
  for (const Library& library : libraries())
    EXPECT_THAT(text, HasSubstr(library.name + ' ' + library.version + '\n'));
}

} // namespace
} // namespace espalier
