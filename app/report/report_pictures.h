#pragma once

#include "app/report/report_data.h"
#include "ui/view/camera.h"
#include "ui/view/scene.h"

#include <Eigen/Geometry>
#include <QImage>
#include <QSize>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

namespace espalier {

/// The pictures of a report; those that could not be drawn are null.
struct ReportPictures {
  QImage front;               // the result, and what it misses, colored by what differs
  QImage side;                //
  QImage result;              // each alone, as thick as it is
  QImage reference;           //
  QImage scan;                // the points by height
  std::vector<QImage> errors; // of shownErrors()
  QString problem;            // why there are none; empty: there are
};

/// Draws the pictures of a report one by one, so that a window may answer in between. Needs a
/// QGuiApplication, but no display.
class PictureSession {
public:
  /// @param up of the frame of the scan
  explicit PictureSession(const ReportData& data, UpAxis up = UpAxis::z, QString unit = {});
  /// Of one plant by itself: front, side and scan.
  /// @param scan may be null
  PictureSession(const Skeleton& plant, std::shared_ptr<const PointCloud> scan, UpAxis up,
                 QString unit = {});
  PictureSession(const PictureSession&) = delete; // what it draws is within it
  PictureSession& operator=(const PictureSession&) = delete;

  /// Draws the next one. False: all are drawn, or there is no OpenGL, which `pictures` then says.
  bool drawNext();
  [[nodiscard]] double done() const; // in [0, 1]
  [[nodiscard]] const ReportPictures& pictures() const { return pictures_; }

private:
  /// A place that is ringed.
  struct Mark {
    Eigen::Vector3d place; // [L], frame of the scan
    bool isDashed;
  };
  struct Shot {
    const Scene* scene;
    Camera camera;
    QSize size;                                  // [pixels]
    QImage ReportPictures::*place;               // null: the next of the errors
    std::optional<Eigen::AlignedBox3d> box = {}; // nothing else is drawn
    std::vector<Mark> marks = {};
  };
  void addWholes(bool hasScan);
  [[nodiscard]] Camera cameraFrom(StandardView view, double aspect) const; // of the plants
  [[nodiscard]] Camera cameraFrom(StandardView view, double aspect, const Scene& scene) const;
  void addErrors(const ReportData& data);
  [[nodiscard]] QImage draw(const Shot& shot) const;

  QString unit_;
  Scene both_;
  Scene result_;
  Scene reference_;
  Scene scan_;
  std::vector<Shot> shots_;
  std::size_t next_ = 0;
  ReportPictures pictures_;
};

/// All of them at once.
[[nodiscard]] ReportPictures reportPictures(const ReportData& data, UpAxis up, const QString& unit);

} // namespace espalier
