#include "ui/dialogs/about_dialog.h"

#include "ui/document/manual_place.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSysInfo>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

namespace espalier {
namespace {

QWidget* makeTitle(const AboutDialog::About& about) {
  auto* title = new QWidget;
  auto* row = new QHBoxLayout(title);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(16);
  auto* icon = new QLabel;
  icon->setPixmap(about.icon.pixmap(64, 64));
  row->addWidget(icon);
  auto* text = new QLabel(AboutDialog::tr("<b>Espalier %1</b><br>From a laser scan of a plant to a "
                                          "skeleton an expert would sign.")
                              .arg(about.version.toHtmlEscaped()));
  text->setObjectName("about_text");
  text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addWidget(text, 1);
  return title;
}

QTableWidget* makeTable(const QList<QStringList>& libraries) {
  const QStringList headings = {AboutDialog::tr("Library"), AboutDialog::tr("Version"),
                                AboutDialog::tr("License"), AboutDialog::tr("Used for")};
  auto* table =
      new QTableWidget(static_cast<int>(libraries.size()), static_cast<int>(headings.size()));
  table->setObjectName("about_libraries");
  table->setAccessibleName(AboutDialog::tr("Libraries"));
  table->setHorizontalHeaderLabels(headings);
  table->verticalHeader()->hide();
  table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table->horizontalHeader()->setStretchLastSection(true);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setFrameShape(QFrame::NoFrame);
  table->setShowGrid(false);
  for (int row = 0; row < table->rowCount(); ++row)
    for (int column = 0; column < table->columnCount(); ++column)
      table->setItem(row, column, new QTableWidgetItem(libraries[row][column]));
  table->resizeColumnsToContents();
  return table;
}

} // namespace

AboutDialog::AboutDialog(const About& about, QWidget* parent) : QDialog(parent) {
  setObjectName("about_dialog");
  setManualPlace(*this, QStringLiteral("troubleshooting.md#crashes-and-the-log"));
  setWindowTitle(tr("About Espalier"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(640, 520);
  auto* license = new QPlainTextEdit(about.license);
  license->setObjectName("about_license");
  license->setReadOnly(true);
  license->setFrameShape(QFrame::NoFrame);
  auto* pages = new QTabWidget;
  pages->setDocumentMode(true);
  pages->addTab(makeTable(about.libraries), tr("Libraries"));
  pages->addTab(license, tr("License"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QPushButton* copy = buttons->addButton(tr("Copy Versions"), QDialogButtonBox::ActionRole);
  copy->setObjectName("about_copy");
  copy->setToolTip(tr("Copies what a report of a problem begins with"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(24, 20, 24, 16);
  column->setSpacing(16);
  column->addWidget(makeTitle(about));
  column->addWidget(pages, 1);
  column->addWidget(buttons);
  connect(copy, &QPushButton::clicked, this,
          [text = versionsText(about)] { QGuiApplication::clipboard()->setText(text); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

QString AboutDialog::versionsText(const About& about) {
  QStringList lines = {QStringLiteral("Espalier %1").arg(about.version),
                       QSysInfo::prettyProductName() + ", " + QSysInfo::currentCpuArchitecture()};
  for (const QStringList& library : about.libraries)
    lines.append(library[0] + ' ' + library[1]);
  return lines.join('\n') + '\n';
}

} // namespace espalier
