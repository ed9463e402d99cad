#include "app/report/write_report.h"

#include "app/report/html_report.h"
#include "app/report/pdf_report.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/atomic_file.h"

#include <array>
#include <ostream>
#include <string_view>
#include <utility>

namespace espalier {
namespace {

using Writer = QByteArray (*)(const Report&);

constexpr std::array<std::pair<std::string_view, Writer>, 3> writers{
    {{".html", htmlOf}, {".htm", htmlOf}, {".pdf", pdfOf}}};

Writer writerOf(const std::filesystem::path& path) {
  const std::string extension = lowerCase(path.extension().string());
  for (const auto& [known, writer] : writers)
    if (known == extension) return writer;
  throw Error(path.string() +
              ": a report is written as HTML or PDF: choose a name that ends in .html or .pdf");
}

} // namespace

void requireReportName(const std::filesystem::path& path) {
  static_cast<void>(writerOf(path));
}

void writeReport(const std::filesystem::path& path, const Report& report) {
  const QByteArray bytes = writerOf(path)(report);
  writeAtomically(path, [&](std::ostream& out) {
    out.write(bytes.constData(), static_cast<std::streamsize>(bytes.size()));
  });
}

} // namespace espalier
