#pragma once

#include "app/report/certificate.h"
#include "core/skeleton/finding.h"

namespace espalier::test {

/// With all that a seal can state.
inline Seal wholeSeal() {
  return {.author = "Anna",
          .time = 1'763'733'909'123,
          .work = {{.edits = 12, .added = 40, .removed = 7, .moved = 19}, 3'600'000},
          .nodes = 3358,
          .length = 156.486,
          .review = ReviewRecord{.lookedAt = {3000, 140},
                                 .inBulk = {300, 16},
                                 .before = {58, 0.5},
                                 .doubted = {20, 1},
                                 .comments = 9},
          .state = SealedState{
              .findings = {{"sharp_turn", 2}, {"crossing", 1}},
              .ignored = 5,
              .points = 147'989,
              .unexplained = 1480,
              .ignoredPlaces = 3,
              .ignoredPoints = 444,
              .questions = SealedQuestions{.answered = 14, .open = 2},
              .automatic = SealedAgreement{"the reconstruction", 0.01, 0.91, 0.85, 0.879, 0.84},
              .other = SealedAgreement{"second.mtg", 0.01, 0.98, 0.97, 0.975, 0.93},
              .reason = "the two turns are real"}};
}

inline CertificateAbout aboutSeal() {
  return {.plant = {"pine.espalier", QString(64, 'a')},
          .scan = ReportedFile{"pine.ply", QString(64, 'b')},
          .version = "9.8.7",
          .unit = LengthUnit::meter,
          .comments = {}};
}

/// With more of everything than has room.
inline Report crowdedCertificate() {
  ReportPictures pictures;
  for (QImage ReportPictures::*each :
       {&ReportPictures::front, &ReportPictures::side, &ReportPictures::scan}) {
    pictures.*each = QImage(900, 1200, QImage::Format_RGB32);
    (pictures.*each).fill(Qt::white);
  }
  CertificateAbout crowded = aboutSeal();
  for (std::size_t i = 0; i < 30; ++i)
    crowded.comments.push_back({QString("a twig that may be dead, ").repeated(8), "Anna", 30});
  Seal seal = wholeSeal();
  for (int kind = 0; kind < findingKinds; ++kind)
    seal.state->findings[nameOf(static_cast<Finding::Kind>(kind))] = 100;
  seal.state->reason = QString("as it stands in the scan, ").repeated(11).toStdString();
  return certificate(seal, pictures, crowded);
}

} // namespace espalier::test
