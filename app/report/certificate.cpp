#include "app/report/certificate.h"

#include "app/report/pdf_report.h"
#include "app/report/report_sections.h"
#include "ui/document/seal_text.h"

#include <algorithm>
#include <map>

namespace espalier {
namespace {

constexpr qsizetype longestComment = 80; // letters

/// How much of the page is for what may be less.
struct CertificateRoom {
  int figuresAcross = 5;
  std::size_t comments = 10; // at most
};

QString shortened(const QString& text) {
  return text.size() <= longestComment ? text : text.left(longestComment - 1) + QChar(0x2026);
}

ReportWarnings warningsOf(const Seal& seal) {
  ReportWarnings warnings;
  if (!seal.state)
    warnings.lines.append(ReportText::tr(
        "the seal is of an older program, which kept neither findings nor agreements"));
  else if (const std::size_t open = seal.state->openFindings(); open > 0)
    warnings.lines.append(
        ReportText::tr("findings of the checks that were open: %1 (why they were left is below)")
            .arg(formatCount(open)));
  if (seal.review && seal.review->inBulk.nodes > 0)
    warnings.lines.append(
        ReportText::tr("%1 of %2 nodes were marked as reviewed in bulk")
            .arg(formatCount(seal.review->inBulk.nodes), formatCount(seal.nodes)));
  if (seal.review && seal.review->before.nodes > 0)
    warnings.lines.append(
        ReportText::tr("%1 of %2 nodes were reviewed before the plant was opened")
            .arg(formatCount(seal.review->before.nodes), formatCount(seal.nodes)));
  return warnings;
}

ReportFigures figures(const ReportPictures& pictures, int across) {
  ReportFigures shown{.across = across, .figures = {}};
  const auto add = [&](const QImage& image, const QString& title) {
    if (!image.isNull()) shown.figures.push_back({image, title, {}});
  };
  add(pictures.front, ReportText::tr("From the front"));
  add(pictures.side, ReportText::tr("From the right"));
  add(pictures.scan, ReportText::tr("The scan"));
  return shown;
}

ReportTable sealTable(const Seal& seal, LengthUnit unit) {
  ReportTable table;
  table.caption = ReportText::tr("When it was signed");
  table.columns = {{ReportText::tr("what"), false}, {ReportText::tr("how much"), false}};
  for (const SealRow& row : sealRows(seal, unit))
    table.rows.push_back({{row.name}, {row.text}});
  return table;
}

QString placeOf(const SealedComment& comment) {
  const QString first = QString::number(indexOf(comment.first));
  return comment.nodes == 1
             ? first
             : ReportText::tr("%1 and %2 more", "nodes").arg(first, formatCount(comment.nodes - 1));
}

ReportTable commentsTable(const std::vector<SealedComment>& comments, std::size_t most) {
  ReportTable table;
  table.columns = {{ReportText::tr("comment"), false},
                   {ReportText::tr("by"), false},
                   {ReportText::tr("at node")}};
  for (const SealedComment& comment : comments)
    if (table.rows.size() < most)
      table.rows.push_back({{shortened(comment.text)}, {comment.reviewer}, {placeOf(comment)}});
  if (comments.size() > most)
    table.rows.push_back(
        {{ReportText::tr("and %1 more, in the project").arg(comments.size() - most)}, {}, {}});
  return table;
}

Report certificateIn(const CertificateRoom& room, const Seal& seal, const ReportPictures& pictures,
                     const CertificateAbout& about) {
  Report report{.title = ReportText::tr("Certificate of a reference"),
                .facts = {about.plant.name, ReportText::tr("Espalier %1").arg(about.version)},
                .sections = {}};
  ReportSection statement{ReportText::tr("Signed by %1").arg(signatureOf(seal)), {}};
  statement.blocks.emplace_back(ReportParagraph{
      seal.isAllLookedAt()
          ? ReportText::tr("The signer has looked at all of this structure, and to their knowledge "
                           "it is right.")
          : ReportText::tr("To the signer's knowledge this structure is right, also where they did "
                           "not look closely.")});
  if (ReportWarnings warnings = warningsOf(seal); !warnings.lines.isEmpty())
    statement.blocks.emplace_back(std::move(warnings));
  if (ReportFigures shown = figures(pictures, room.figuresAcross); !shown.figures.empty())
    statement.blocks.emplace_back(std::move(shown));
  statement.blocks.emplace_back(sealTable(seal, about.unit));
  if (!about.comments.empty())
    statement.blocks.emplace_back(commentsTable(about.comments, room.comments));
  std::vector<std::pair<QString, ReportedFile>> files = {
      {ReportText::tr("structure"), about.plant}};
  if (about.scan) files.emplace_back(ReportText::tr("scan"), *about.scan);
  statement.blocks.emplace_back(inputsTable(files));
  if (!pictures.problem.isEmpty())
    statement.blocks.emplace_back(
        ReportParagraph{ReportText::tr("There are no pictures: %1").arg(pictures.problem),
                        ReportParagraph::Look::note});
  report.sections.push_back(std::move(statement));
  return report;
}

} // namespace

std::vector<SealedComment> commentsOf(const Skeleton& skeleton) {
  std::map<std::string, SealedComment> found;
  for (const NodeId id : skeleton.ids()) {
    const ReviewMark& mark = skeleton[id].review;
    if (mark.comment.empty()) continue;
    SealedComment& comment = found[mark.comment];
    if (comment.nodes++ > 0) continue;
    comment.text = QString::fromStdString(mark.comment);
    comment.reviewer = QString::fromStdString(mark.reviewer);
    comment.first = id;
  }
  std::vector<SealedComment> comments;
  comments.reserve(found.size());
  for (const auto& [text, comment] : found)
    comments.push_back(comment);
  std::ranges::stable_sort(comments, std::greater<>(), &SealedComment::nodes);
  return comments;
}

Report certificate(const Seal& seal, const ReportPictures& pictures,
                   const CertificateAbout& about) {
  CertificateRoom room;
  room.comments = std::min(room.comments, about.comments.size());
  Report report = certificateIn(room, seal, pictures, about);
  while (pdfPagesOf(report) > 1 && (room.comments > 0 || room.figuresAcross < 8)) {
    if (room.comments > 1)
      --room.comments;
    else if (room.figuresAcross < 8)
      ++room.figuresAcross;
    else
      room.comments = 0;
    report = certificateIn(room, seal, pictures, about);
  }
  return report;
}

} // namespace espalier
