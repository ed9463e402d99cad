#pragma once

#include "app/report/choice_record.h"
#include "app/report/report.h"
#include "app/report/report_data.h"
#include "app/report/report_pictures.h"
#include "core/base/progress.h"
#include "core/pipeline/pipeline_options.h"
#include "core/project/corrections.h"

#include <QString>

#include <filesystem>
#include <optional>

namespace espalier {

/// What was compared, so that a reader of the report cannot mistake it for anything else.
struct ReportedFile {
  QString name;            // for people
  QString fingerprint;     // SHA-256 of its bytes; empty: it is no file as it lies
  QString note = {};       // what was done to it since
  QString path = {};       // as it was given; empty: it is no file as it lies
  bool isToExport = false; // before a command can read it: it is in no file yet, or in a project
};

/// The file as it lies on the disk.
/// @throws Error if it cannot be read
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] ReportedFile reportedFile(const std::filesystem::path& path,
                                        const Progress& progress = {});

/// What a report states beside its numbers.
struct ReportAbout {
  ReportedFile result;
  ReportedFile reference;
  std::optional<ReportedFile> scan;
  QString date;          // as it is to be written
  QString version;       // of the program
  QString unit;          // of lengths: "mm"; empty: not known
  double scale = 1;      // that the result was multiplied by
  double distance = 0;   // [L], the tolerance that was asked for; 0: by the rule
  bool turns = true;     // turns were looked for
  UpAxis up = UpAxis::z; // all angles about it
  EditOptions edit;
  std::optional<PipelineOptions> made = {}; // of the result; none: not known
  std::vector<ChoiceRecord> choices = {};   // of options
  std::optional<HandWork> handWork;         // none: the result has no history
};

/// The report of a comparison. Deterministic: it reads no clock.
[[nodiscard]] Report comparisonReport(const ReportData& data, const ReportPictures& pictures,
                                      const ReportAbout& about);

} // namespace espalier
