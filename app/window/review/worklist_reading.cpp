#include "app/window/review/worklist_reading.h"

#include "app/window/review/sealed_facts.h"
#include "core/evaluate/match/comparable.h"
#include "core/io/formats.h"
#include "core/io/glance.h"
#include "core/project/content_hash.h"
#include "ui/document/shown_message.h"
#include "ui/panels/plant_picture.h"

#include <QDir>
#include <QFileInfo>

#include <exception>
#include <system_error>

namespace espalier {
namespace {

namespace fs = std::filesystem;

constexpr int pictureSize = 96; // [pixels], for screens of high resolution, too

void stamp(const fs::path& path, std::int64_t& time, std::uint64_t& size) {
  std::error_code isMissing;
  const auto bytes = fs::file_size(path, isMissing);
  if (isMissing) return;
  size = bytes;
  time = fs::last_write_time(path, isMissing).time_since_epoch().count();
}

FileStamp stampOf(const fs::path& path) {
  FileStamp found;
  stamp(path, found.time, found.size);
  stamp(path.string() + "-wal", found.waitingTime, found.waitingSize);
  return found;
}

QString hexOf(std::uint64_t value) {
  return QStringLiteral("%1").arg(value, 16, 16, QLatin1Char('0'));
}

/// Of all pictures of a file.
QString beginningOfName(const fs::path& file) {
  return hexOf(contentHash(file.string())) + "-";
}

QString nameOfPicture(const fs::path& file, const FileStamp& stamp) {
  const std::string text = std::to_string(stamp.time) + " " + std::to_string(stamp.size) + " " +
                           std::to_string(stamp.waitingTime) + " " +
                           std::to_string(stamp.waitingSize);
  return beginningOfName(file) + hexOf(contentHash(text)) + ".png";
}

/// Some of its points: those that a glance has seen, else of a file that is read quickly.
std::vector<Eigen::Vector3d> someOf(const fs::path& scan, const PointGlance& glance,
                                    const Progress& progress) {
  constexpr std::uint64_t quick = 5'000'000; // points
  constexpr std::uint64_t some = 1 << 14;
  if (!glance.sample.empty() || glance.points > quick) return glance.sample;
  const PointCloud cloud = readPoints(scan, {.most = some}, progress).value;
  std::vector<Eigen::Vector3d> places;
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    places.push_back(cloud.position(i));
  return places;
}

UpAxis upOfGlance(const PointGlance& glance) {
  if (glance.up.value == "x") return UpAxis::x;
  return glance.up.value == "y" ? UpAxis::y : UpAxis::z;
}

} // namespace

SurveyedWorklist surveyWorklist(const fs::path& place) {
  SurveyedWorklist found;
  try {
    found.list = readWorklist(place);
  } catch (const std::exception& error) {
    found.problem = shownText(error);
    return found;
  }
  for (const fs::path& project : found.list.projects)
    found.stamps.emplace(project, stampOf(project));
  for (const WorklistLine& line : found.list.lines)
    if (!line.file.empty()) found.stamps.emplace(line.file, stampOf(line.file));
  return found;
}

QImage PictureCache::find(const fs::path& file, const FileStamp& stamp) const {
  return QImage(folder + "/" + nameOfPicture(file, stamp));
}

void PictureCache::keep(const fs::path& file, const FileStamp& stamp, const QImage& picture) const {
  QDir().mkpath(folder);
  QDir pictures(folder);
  for (const QString& older : pictures.entryList({beginningOfName(file) + "*"}, QDir::Files))
    pictures.remove(older);
  (void)picture.save(pictures.filePath(nameOfPicture(file, stamp)));
}

ReadPlant readProjectOf(const fs::path& project, const FileStamp& stamp,
                        const PictureCache& pictures, const Progress& progress) {
  ReadPlant plant;
  try {
    const Project opened = Project::open(project, Access::readOnly);
    progress.check();
    const Imported<History> read = opened.lastWork();
    const History& work = read.value;
    if (!read.notes.empty()) plant.work.problem = read.notes.front();
    progress.check();
    plant.work.state = workState(opened, work);
    plant.picture = pictures.find(project, stamp);
    if (!plant.picture.isNull() || work.skeleton.isEmpty()) return plant;
    plant.picture = pictureOf(work.skeleton, pictureSize);
    pictures.keep(project, stamp, plant.picture);
  } catch (const std::exception& error) {
    plant.work.problem = messageOf(error);
  }
  return plant;
}

ReadPlant readScanOf(const fs::path& scan, const FileStamp& stamp, const PictureCache& pictures,
                     const Progress& progress) {
  ReadPlant plant{.picture = pictures.find(scan, stamp)};
  if (!plant.picture.isNull()) return plant;
  try {
    const PointGlance glance = glanceAt(scan);
    plant.picture = pictureOf(someOf(scan, glance, progress), upOfGlance(glance), pictureSize);
    pictures.keep(scan, stamp, plant.picture);
  } catch (const std::exception& error) {
    plant.work.problem = messageOf(error);
  }
  return plant;
}

KnownWork readHashOf(const fs::path& scan, const Progress& progress) {
  try {
    return {.hash = contentHashOfFile(scan, progress)};
  } catch (const std::exception& error) {
    return {.problem = messageOf(error)};
  }
}

std::optional<SealedAgreement> agreementOf(const fs::path& project, const fs::path& second,
                                           const Progress& progress) {
  try {
    const History plant = Project::open(project, Access::readOnly).lastWork().value;
    const Project other = Project::open(second, Access::readOnly);
    const History reference = other.lastWork().value;
    if (!(totalLength(plant.skeleton) > 0) || !(totalLength(reference.skeleton) > 0))
      return std::nullopt;
    return agreement(workState(other, reference).annotator, plant.skeleton, reference.skeleton, 0,
                     progress);
  } catch (const std::exception&) { // its row says why it cannot be read
    return std::nullopt;
  }
}

} // namespace espalier
