#pragma once

#include "core/base/progress.h"
#include "core/worklist/worklist.h"

#include <QImage>
#include <QString>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>

namespace espalier {

// What a worklist reads in the background. Nothing that is wrong with a plant is thrown, whatever
// it is: it is said of that plant, and the rest goes on.

/// By which it is seen that a file has changed; of a project, what waits in its journal counts,
/// too.
struct FileStamp {
  std::int64_t time = 0; // of the last change, of whatever clock
  std::uint64_t size = 0;
  std::int64_t waitingTime = 0;
  std::uint64_t waitingSize = 0;

  bool operator==(const FileStamp&) const = default;
};
using FileStamps = std::map<std::filesystem::path, FileStamp>;

/// A worklist as it is now, with the stamps of all its projects and scans.
struct SurveyedWorklist {
  Worklist list;
  FileStamps stamps;
  QString problem; // why it cannot be read; empty: it can
};
[[nodiscard]] SurveyedWorklist surveyWorklist(const std::filesystem::path& place);

/// A plant, and its picture.
struct ReadPlant {
  KnownWork work = {};
  QImage picture = {}; // null: there is nothing to draw
};

/// Where pictures are kept: one for each file, in a folder of the cache.
struct PictureCache {
  QString folder;

  [[nodiscard]] QImage find(const std::filesystem::path& file, const FileStamp& stamp) const;
  /// In place of older pictures of the file. What cannot be written is made again next time.
  void keep(const std::filesystem::path& file, const FileStamp& stamp, const QImage& picture) const;
};

/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] ReadPlant readProjectOf(const std::filesystem::path& project, const FileStamp& stamp,
                                      const PictureCache& pictures, const Progress& progress);
/// The picture of a scan, from some of its points. LAZ and E57 are unpacked for it, up to 5 million
/// points; larger ones have none.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] ReadPlant readScanOf(const std::filesystem::path& scan, const FileStamp& stamp,
                                   const PictureCache& pictures, const Progress& progress);
/// What a scan holds, by its hash: it is read whole.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] KnownWork readHashOf(const std::filesystem::path& scan, const Progress& progress);

/// How two projects of one scan agree; none: one of them has no length, or cannot be read.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::optional<SealedAgreement> agreementOf(const std::filesystem::path& project,
                                                         const std::filesystem::path& second,
                                                         const Progress& progress);

} // namespace espalier
