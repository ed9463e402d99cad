#include "ui/dialogs/manual_chapters.h"

#include "core/pipeline/option_text.h"
#include "core/pipeline/pipeline_options.h"
#include "core/pipeline/registry.h"
#include "ui/document/shown_text.h"

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <QStringList>

/// The chapters lie in a static library, which the linker else leaves out. Not in a namespace, as
/// the macro asks.
static void useManual() {
  Q_INIT_RESOURCE(manual);
}

namespace espalier {
namespace {

QByteArray resourceNamed(const QString& name) {
  QFile file(QStringLiteral(":/manual/") + name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A chapter in this language, where there is one, else in English. Its pictures and links are
/// those beside the English one.
QString chapterNamed(const QString& file, const QString& language) {
  const QString text = QString::fromUtf8(resourceNamed(language + '/' + file));
  return text.isEmpty() ? QString::fromUtf8(resourceNamed(file))
                        : QString(text).replace(QStringLiteral("](../"), QStringLiteral("]("));
}

QString shown(const std::string& text) {
  return QString::fromStdString(text);
}

/// In a cell of a table, a bar would begin the next one.
QString cell(QString text) {
  return text.replace('|', QStringLiteral("\\|"));
}

/// Of a table: a row for each method of a step that says what it is good for.
QString methodRows(const Step& step) {
  QStringList rows;
  for (const Method& method : step.methods)
    if (!method.inManual.empty())
      rows.append(QStringLiteral("| %1 | %2 | %3 |")
                      .arg(cell(shownText(method.label)), cell(shownText(method.inManual)),
                           cell(shown(method.source))));
  return rows.join('\n');
}

QString optionRow(const Step& step, const Option& option) {
  return QStringLiteral("| %1 | `%2.%3` | %4 | %5 | %6 |\n")
      .arg(cell(shownText(option.label)), shown(step.name), shown(option.name),
           cell(shown(option.ruleText())), cell(shown(rangeText(option))),
           cell(shownText(option.help)));
}

/// The pictures that show what options of the method do: "option-contract-radius.png".
QString optionPictures(const Step& step, const Method& method) {
  QString text;
  for (const Option& option : method.options) {
    const QString name = QStringLiteral("option-%1-%2-%3.png")
                             .arg(shown(step.name), shown(method.name), shown(option.name));
    if (QFile::exists(QStringLiteral(":/manual/") + name))
      text += QStringLiteral("\n![%1: a quarter of the default, the default, four times it](%2)\n")
                  .arg(shownText(option.label), name);
  }
  return text;
}

/// All methods of a step with all their options.
QString methodsOf(const Step& step) {
  QString text = QStringLiteral("## %1\n\n%2%3\n")
                     .arg(shownText(step.label), shownText(step.help),
                          isOff(step, {}) ? QStringLiteral(" Off at first.") : QString());
  for (const Method& method : step.methods) {
    text += QStringLiteral("\n### %1: %2\n\n`--set %3.method=%4`%5. %6")
                .arg(shownText(step.label), shownText(method.label), shown(step.name),
                     shown(method.name),
                     &method == &step.methods.front() ? QStringLiteral(", the default") : QString(),
                     shownText(method.help));
    if (!method.source.empty()) text += QStringLiteral(" Source: %1.").arg(shown(method.source));
    text += '\n';
    if (method.options.empty()) continue;
    text += QStringLiteral("\n| option | name | default | range | does |\n|---|---|---|---|---|\n");
    for (const Option& option : method.options)
      text += optionRow(step, option);
    text += optionPictures(step, method);
  }
  return text;
}

/// "{methods contract}" becomes the rows of a table, "{options}" all methods with their options.
QString withTables(QString text) {
  QString all;
  for (const Step& step : pipelineSteps()) {
    const QString rows = QStringLiteral("{methods %1}").arg(shown(step.name));
    if (text.contains(rows)) text.replace(rows, methodRows(step));
    all += methodsOf(step) + '\n';
  }
  return text.replace(QStringLiteral("{options}"), all);
}

QString titleOf(const QString& text) {
  static const QRegularExpression heading(QStringLiteral("^# (.+)$"),
                                          QRegularExpression::MultilineOption);
  return heading.match(text).captured(1);
}

} // namespace

std::vector<ManualChapter> manualChaptersIn(const QString& language) {
  useManual();
  const QString first = QStringLiteral("README.md");
  static const QRegularExpression link(QStringLiteral("^- \\[[^\\]]+\\]\\(([a-z0-9-]+\\.md)\\)$"));
  std::vector<ManualChapter> chapters(1);
  QStringList list;
  for (const QString& line : QString::fromUtf8(resourceNamed(first)).split('\n')) {
    const QString file = link.match(line).captured(1);
    const QString text = file.isEmpty() ? QString() : chapterNamed(file, language);
    if (!file.isEmpty() && text.isEmpty()) continue;
    list.append(file.isEmpty() ? line : QStringLiteral("- [%1](%2)").arg(titleOf(text), file));
    if (!file.isEmpty()) chapters.push_back({file, titleOf(text), withTables(text)});
  }
  const QString text = list.join('\n');
  chapters.front() = {first, titleOf(text), text};
  return chapters;
}

const std::vector<ManualChapter>& manualChapters() {
  static const std::vector<ManualChapter> chapters = manualChaptersIn(QCoreApplication::translate(
      "espalier::ManualWindow", "en", "the folder of the chapters in this language: fr"));
  return chapters;
}

QByteArray manualPicture(const QString& name) {
  useManual();
  return resourceNamed(name);
}

QString manualAnchor(const QString& heading) {
  QString anchor;
  for (const QChar letter : heading.toLower())
    if (letter.isLetterOrNumber() || letter == '-' || letter == '_')
      anchor += letter;
    else if (letter.isSpace())
      anchor += '-';
  return anchor;
}

} // namespace espalier
