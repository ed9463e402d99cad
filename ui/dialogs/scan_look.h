#pragma once

#include "core/graph/find_root.h"
#include "core/io/points/first_lines.h"
#include "core/io/points/point_glance.h"
#include "core/io/points/read_options.h"
#include "ui/document/length_unit.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// How a scan is to be read and shown, as its user says.
struct ScanChoices {
  ReadOptions reading;
  LengthUnit unit = LengthUnit::unknown;
  UpAxis up = UpAxis::z;
};

/// What is known of a scan before it is read.
struct ScanLook {
  QString path;
  QString format; // its name: "XYZ"
  PointGlance glance;
  std::optional<FirstLines> text;       // of a text file
  std::vector<PointField> columns = {}; // that a user named of such a file; empty: found out
  QString alike = {};   // what such files have in common that begin alike; empty: nothing
  QString failure = {}; // why it could not be read, the last time it was tried
  std::optional<ScanChoices> chosen = {}; // by which that was tried
  /// Of another scan of a plant, which is laid on the first: it has the unit and the up axis of it.
  std::optional<LengthUnit> unit = {};
  std::optional<UpAxis> up = {};
};

/// What was found out of it, with the unit and the up axis that are known.
[[nodiscard]] PointGlance glanceOf(const ScanLook& look);

/// Why the columns of a text file are to be looked at, in a sentence; empty: they are clear.
[[nodiscard]] QString columnsQuestion(const ScanLook& look);

/// What is to be decided before it is read, a sentence each; empty: nothing.
[[nodiscard]] QStringList questionsOf(const ScanLook& look, std::uint64_t mostAtOnce);

/// "all 20 903 points": "about", if that is not known for certain.
[[nodiscard]] QString pointsText(std::uint64_t points, bool isEstimated);

/// How many points, and what they have beside their positions: "1 065, with intensity and color".
[[nodiscard]] QString contentText(const PointGlance& glance);

/// The columns that are taken, and what is left out.
[[nodiscard]] QString columnsText(const PointGlance& glance);

/// From where to where the points reach along each axis.
[[nodiscard]] QString boundsText(const PointGlance& glance);

/// Along each axis, in the unit of the file and, if that is another, in meters.
[[nodiscard]] QString sizeText(const PointGlance& glance, LengthUnit unit);

/// Whether the file states it or it is guessed, and by what.
[[nodiscard]] QString reasonText(const GlanceGuess& guess);

/// The memory that so many points take once they are shown, about: "450 MB".
[[nodiscard]] QString memoryText(std::uint64_t points);

/// How many points of the file lie in the box, by those that were looked at; none were: not known.
[[nodiscard]] std::optional<std::uint64_t> pointsIn(const Eigen::AlignedBox3d& box,
                                                    const PointGlance& glance);

/// So many that steps of the last are a thousandth of a plant in these bounds.
[[nodiscard]] int decimalsIn(const Eigen::AlignedBox3d& bounds);

} // namespace espalier
