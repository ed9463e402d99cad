#include "app/report/report_sections.h"
#include "ui/document/shown_text.h"

#include <QLocale>
#include <QRegularExpression>
#include <QtGlobal>

#include <numbers>
#include <set>

namespace espalier {
namespace {

class SettingsTable {
public:
  SettingsTable() {
    table_.columns = {{ReportText::tr("setting"), false}, {ReportText::tr("value"), false}};
  }
  void add(const QString& name, const QString& value) { table_.rows.push_back({{name}, {value}}); }
  [[nodiscard]] ReportTable table(const QString& caption) const {
    ReportTable made = table_;
    made.caption = caption;
    return made;
  }

private:
  ReportTable table_;
};

QString joined(const ReportNumbers& numbers, const std::vector<double>& lengths) {
  QStringList texts;
  for (const double length : lengths)
    texts.append(numbers.given(length));
  const QString all = texts.join(QStringLiteral(", "));
  return numbers.unit().isEmpty() ? all : all + QChar(0x202f) + numbers.unit();
}

QString turnText(const Registration& lay, const ReportNumbers& numbers) {
  if (lay.angle() == 0) return ReportText::tr("none");
  const Eigen::Vector3d axis = lay.axis();
  return ReportText::tr("%1 about (%2, %3, %4) through its middle")
      .arg(numbers.degrees(lay.angle()), numbers.share(axis.x()), numbers.share(axis.y()),
           numbers.share(axis.z()));
}

void addRegistration(SettingsTable& table, const ReportParts& parts) {
  const auto& registration = parts.data.comparison.registration;
  const ReportNumbers& numbers = parts.numbers;
  if (!registration) {
    table.add(ReportText::tr("registration"), ReportText::tr("none: compared where they lie"));
    return;
  }
  const Eigen::Vector3d& shift = registration->shift;
  table.add(ReportText::tr("registration"),
            ReportText::tr("the plant was moved to lie on the reference"));
  table.add(ReportText::tr("turns tried about"),
            parts.about.turns ? QString(QLatin1Char("xyz"[static_cast<int>(parts.about.up)]))
                              : ReportText::tr("none"));
  table.add(ReportText::tr("turn about x, y, z"), turnText(*registration, numbers));
  table.add(ReportText::tr("shift x, y, z"), joined(numbers, {shift.x(), shift.y(), shift.z()}));
  table.add(ReportText::tr("shift in all"), numbers.length(shift.norm()));
  table.add(ReportText::tr("mean distance before, after"),
            joined(numbers, {registration->residualBefore, registration->residualAfter}));
  table.add(ReportText::tr("counted up to"), numbers.length(registration->reach));
  table.add(
      ReportText::tr("length of both within %1").arg(numbers.length(registration->nearDistance)),
      numbers.percent(registration->near));
}

ReportTable settings(const ReportParts& parts) {
  const Comparison& comparison = parts.data.comparison;
  const ReportNumbers& numbers = parts.numbers;
  SettingsTable table;
  table.add(ReportText::tr("unit of lengths"),
            parts.about.unit.isEmpty() ? ReportText::tr("that of the files") : parts.about.unit);
  table.add(ReportText::tr("scale of the plant"), numbers.given(parts.about.scale));
  addRegistration(table, parts);
  table.add(ReportText::tr("tolerance"), numbers.givenLength(parts.data.tolerance));
  std::vector<double> distances;
  for (const ToleranceScore& score : comparison.tolerance.scores)
    distances.push_back(score.distance);
  table.add(ReportText::tr("distances of the table"), joined(numbers, distances));
  table.add(ReportText::tr("step between samples"), numbers.givenLength(comparison.tolerance.step));
  table.add(ReportText::tr("segments are candidates up to"),
            numbers.givenLength(comparison.authors.boxDistance));
  table.add(ReportText::tr("tips and branchings pair up to"),
            numbers.givenLength(comparison.tips.distance));
  table.add(ReportText::tr("by height and order within"),
            numbers.givenLength(comparison.byPlace.distance));
  table.add(ReportText::tr("paths along the plant"),
            ReportText::tr("%1 pairs").arg(numbers.count(comparison.pathLengths.pairs)));
  table.add(ReportText::tr("draws for the intervals"),
            ReportText::tr("%1, seed %2")
                .arg(numbers.count(parts.data.intervals.draws))
                .arg(parts.data.intervals.seed));
  const EditOptions& edit = parts.about.edit;
  table.add(ReportText::tr("edit distance of"),
            ReportText::tr("%1, cost %2%3")
                .arg(QString::fromStdString(editUnitNames()[static_cast<std::size_t>(edit.unit)]),
                     QString::fromStdString(editCostNames()[static_cast<std::size_t>(edit.cost)]),
                     edit.mergesPaths ? ReportText::tr(", paths merged") : QString()));
  table.add(ReportText::tr("up"), QStringLiteral("z"));
  table.add(ReportText::tr("version"),
            ReportText::tr("Espalier %1, Qt %2").arg(parts.about.version, qVersion()));
  return table.table(ReportText::tr("Settings"));
}

ReportTable inputs(const ReportParts& parts) {
  std::vector<std::pair<QString, ReportedFile>> files = {
      {ReportText::tr("plant"), parts.about.result},
      {ReportText::tr("reference"), parts.about.reference}};
  if (parts.about.scan) files.emplace_back(ReportText::tr("scan"), *parts.about.scan);
  return inputsTable(files);
}

const QString exportedName = QStringLiteral("plant.mtg");

/// How the plant is laid on the reference.
QStringList placeFlags(const std::optional<Registration>& registration, const ReportAbout& about) {
  if (!registration) return {QStringLiteral("--no-register")};
  QStringList flags;
  if (registration->isGiven && registration->angle() == 0) {
    flags = {"--shift=" + typedNumbers(registration->motion.translation())};
  } else if (registration->isGiven) {
    const double degrees = registration->angle() * 180 / std::numbers::pi;
    flags = {"--turn=" +
                 typedNumbers((Eigen::Vector4d() << registration->axis(), degrees).finished()),
             "--shift=" + typedNumbers(registration->shift)};
  } else {
    if (!about.turns) flags.append(QStringLiteral("--no-rotate"));
    if (about.up != UpAxis::z)
      flags.append(QStringLiteral("--up %1").arg(QLatin1Char("xyz"[static_cast<int>(about.up)])));
  }
  return flags;
}

/// What to type for the same numbers.
QString commandOf(const ReportParts& parts) {
  const ReportAbout& about = parts.about;
  QStringList words = {QStringLiteral("espalier evaluate"), typedName(about.result),
                       typedName(about.reference)};
  words += placeFlags(parts.data.comparison.registration, about);
  if (about.scan && !about.scan->path.isEmpty())
    words.append(QStringLiteral("--scan ") + typedName(*about.scan));
  if (about.scale != 1) words.append(QStringLiteral("--scale %1").arg(about.scale));
  if (!about.unit.isEmpty()) words.append(QStringLiteral("--unit %1").arg(about.unit));
  if (about.distance > 0)
    words.append(QStringLiteral("--distance %1").arg(about.distance, 0, 'g', 12));
  const Comparison& comparison = parts.data.comparison;
  for (const auto& light : {comparison.resultLight, comparison.referenceLight}) {
    if (!light) continue;
    words.append(QStringLiteral("--light --pixels %1").arg(light->convergence.back().pixels));
    break;
  }
  const EditOptions usual;
  if (about.edit.unit != usual.unit)
    words.append("--edit-unit " + QString::fromStdString(
                                      editUnitNames()[static_cast<std::size_t>(about.edit.unit)]));
  if (about.edit.cost != usual.cost)
    words.append("--edit-cost " + QString::fromStdString(
                                      editCostNames()[static_cast<std::size_t>(about.edit.cost)]));
  if (about.edit.mergesPaths) words.append(QStringLiteral("--merge-paths"));
  words.append(QStringLiteral("--json numbers.json --csv numbers.csv"));
  return words.join(' ');
}

/// The measures that scores of these groups come from.
std::vector<ReportTerms::Term> termsOf(const std::set<ScoreGroup>& groups) {
  std::vector<ReportTerms::Term> terms;
  for (const Measure& measure : measures())
    if (groups.contains(measure.group) && !measure.text.empty())
      terms.push_back({shownText(measure.name), shownText(measure.text),
                       QString::fromStdString(measure.source)});
  return terms;
}

std::vector<ReportTerms::Term> nearnessTerms() {
  std::vector<ReportTerms::Term> terms = termsOf({ScoreGroup::nearness});
  terms.push_back(
      {ReportText::tr("Intervals"),
       ReportText::tr(
           "The segments of the reference are drawn again with replacement; the middle 95 % of the "
           "scores. They show how much depends on which segments this one plant has."),
       QStringLiteral("B. Efron, Bootstrap methods, Annals of Statistics 7, 1979.")});
  return terms;
}

std::vector<ReportTerms::Term> matchingTerms() {
  return termsOf({ScoreGroup::segments, ScoreGroup::capped, ScoreGroup::landmarks,
                  ScoreGroup::network, ScoreGroup::architecture, ScoreGroup::edits});
}

std::vector<ReportTerms::Term> plantTerms(bool hasLight) {
  std::vector<ReportTerms::Term> terms = termsOf({ScoreGroup::radii, ScoreGroup::files});
  const std::vector<ReportTerms::Term> ofEach = traitTerms(hasLight);
  terms.insert(terms.end(), ofEach.begin(), ofEach.end());
  return terms;
}

} // namespace

std::vector<ReportTerms::Term> traitTerms(bool hasLight) {
  std::vector<ReportTerms::Term> terms = {
      {ReportText::tr("Strahler number"),
       ReportText::tr("An apex has 1; a node has the greatest number above it, and one more where "
                      "several have "
                      "that."),
       QStringLiteral("A. Strahler, GSA Bulletin 63, 1952.")},
      {ReportText::tr("Crown and angles"),
       ReportText::tr(
           "The crown is all that branches from the trunk, its area that of its convex hull seen "
           "from above. Divergence is the angle around the axis from one branch to the next."),
       ReportText::tr("Quantities as in PlantScan3D.")}};
  if (hasLight)
    terms.push_back(
        {ReportText::tr("STAR"),
         ReportText::tr(
             "Silhouette to total area of the surface from 46 directions, weighted by the standard "
             "overcast sky."),
         QStringLiteral("H. Sinoquet et al., New Phytologist 175, 2007.")});
  return terms;
}

ReportTable inputsTable(const std::vector<std::pair<QString, ReportedFile>>& inputs) {
  ReportTable table;
  table.caption = ReportText::tr("Inputs");
  table.columns = {{ReportText::tr("role"), false},
                   {ReportText::tr("file"), false},
                   {ReportText::tr("SHA-256"), false}};
  for (const auto& [role, file] : inputs) {
    const QString name =
        file.note.isEmpty() ? file.name : QStringLiteral("%1 (%2)").arg(file.name, file.note);
    table.rows.push_back(
        {{role}, {name}, {file.fingerprint.isEmpty() ? ReportText::tr("none") : file.fingerprint}});
  }
  return table;
}

QString typedWord(const QString& word) {
  static const QRegularExpression plain(QStringLiteral("^[\\w./+:=@%,-]+$"));
  if (plain.match(word).hasMatch()) return word;
  return '\'' + QString(word).replace('\'', QStringLiteral("'\\''")) + '\'';
}

QString typedNumbers(const Eigen::VectorXd& values) {
  QStringList numbers;
  for (const double number : values)
    numbers.append(QString::number(number + 0.0, 'g', QLocale::FloatingPointShortest));
  return numbers.join(',');
}

QString typedName(const ReportedFile& file) {
  if (file.isToExport) return exportedName;
  return typedWord(file.path.isEmpty() ? file.name : file.path);
}

std::vector<ReportBlock> exportAdvice(const ReportedFile& file) {
  if (!file.isToExport) return {};
  return {ReportParagraph{ReportText::tr("Export the plant as %1 first.").arg(exportedName)}};
}

ReportSection settingsSection(const ReportParts& parts) {
  ReportSection section{ReportText::tr("How it was measured"), {inputs(parts), settings(parts)}};
  section.blocks.emplace_back(ReportParagraph{
      ReportText::tr("All numbers as JSON and CSV; they are the values that this report rounds:")});
  for (const ReportBlock& advice : exportAdvice(parts.about.result))
    section.blocks.push_back(advice);
  section.blocks.emplace_back(ReportParagraph{commandOf(parts), ReportParagraph::Look::code});
  return section;
}

ReportTerms scoreTerms() {
  ReportTerms terms{nearnessTerms()};
  for (const ReportTerms::Term& term : matchingTerms())
    terms.terms.push_back(term);
  return terms;
}

ReportSection methodsSection(const ReportParts& parts) {
  const Comparison& comparison = parts.data.comparison;
  ReportTerms terms;
  for (const auto& some :
       {nearnessTerms(), matchingTerms(),
        plantTerms(comparison.resultLight.has_value() || comparison.referenceLight.has_value())})
    terms.terms.insert(terms.terms.end(), some.begin(), some.end());
  return {ReportText::tr("Methods"), {std::move(terms)}};
}

} // namespace espalier
