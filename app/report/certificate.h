#pragma once

#include "app/report/comparison_report.h"
#include "core/project/seal.h"
#include "ui/document/length_unit.h"

#include <QString>

#include <optional>
#include <vector>

namespace espalier {

/// A remark that goes with a signed structure.
struct SealedComment {
  QString text;
  QString reviewer;      // who marked the node; may be empty
  std::size_t nodes = 0; // that have it
  NodeId first{};        // of these

  bool operator==(const SealedComment&) const = default;
};

/// Each remark once, that of most nodes first.
[[nodiscard]] std::vector<SealedComment> commentsOf(const Skeleton& skeleton);

/// What a certificate states beside the seal.
struct CertificateAbout {
  ReportedFile plant;
  std::optional<ReportedFile> scan;
  QString version; // of the program
  LengthUnit unit = LengthUnit::unknown;
  std::vector<SealedComment> comments;
};

/// One page on a signed structure: who stands by it, what it was like when it was signed, and what
/// it looks like. Of many comments, those that have room. Deterministic: it reads no clock. Needs a
/// QGuiApplication, for fonts.
[[nodiscard]] Report certificate(const Seal& seal, const ReportPictures& pictures,
                                 const CertificateAbout& about);

} // namespace espalier
