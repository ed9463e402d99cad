#include "ui/document/finding_title.h"

#include <QCoreApplication>

namespace espalier {
namespace {

struct FindingTitle {
  Q_DECLARE_TR_FUNCTIONS(FindingTitle)
};

} // namespace

QString titleOf(Finding::Kind kind) {
  switch (kind) {
  case Finding::Kind::separatePiece:
    return FindingTitle::tr("Separate pieces");
  case Finding::Kind::twoSuccessors:
    return FindingTitle::tr("Two successors");
  case Finding::Kind::loneBranch:
    return FindingTitle::tr("Lone branches");
  case Finding::Kind::noLength:
    return FindingTitle::tr("Zero-length edges");
  case Finding::Kind::duplicatedEdge:
    return FindingTitle::tr("Duplicated edges");
  case Finding::Kind::sharpTurn:
    return FindingTitle::tr("Sharp turns");
  case Finding::Kind::crossing:
    return FindingTitle::tr("Touching branches");
  case Finding::Kind::loop:
    return FindingTitle::tr("Loops");
  case Finding::Kind::radiusAboveParent:
    return FindingTitle::tr("Thick on thin");
  case Finding::Kind::edgesWithoutPoints:
    return FindingTitle::tr("Edges off the scan");
  case Finding::Kind::noOwnPoints:
    return FindingTitle::tr("No points of their own");
  case Finding::Kind::besidePoints:
    return FindingTitle::tr("Beside its points");
  case Finding::Kind::shortFoot:
    return FindingTitle::tr("Short foot");
  case Finding::Kind::unexplainedPoints:
    return FindingTitle::tr("Bare twigs");
  }
  return {};
}

QString nameOfOne(Finding::Kind kind) {
  switch (kind) {
  case Finding::Kind::separatePiece:
    return FindingTitle::tr("Separate piece");
  case Finding::Kind::loneBranch:
    return FindingTitle::tr("Lone branch");
  case Finding::Kind::noLength:
    return FindingTitle::tr("Zero-length edge");
  case Finding::Kind::duplicatedEdge:
    return FindingTitle::tr("Duplicated edge");
  case Finding::Kind::sharpTurn:
    return FindingTitle::tr("Sharp turn");
  case Finding::Kind::crossing:
    return FindingTitle::tr("Touching branch");
  case Finding::Kind::loop:
    return FindingTitle::tr("Loop");
  case Finding::Kind::edgesWithoutPoints:
    return FindingTitle::tr("Off the scan");
  case Finding::Kind::noOwnPoints:
    return FindingTitle::tr("No own points");
  case Finding::Kind::unexplainedPoints:
    return FindingTitle::tr("Bare twig");
  case Finding::Kind::twoSuccessors:
  case Finding::Kind::radiusAboveParent:
  case Finding::Kind::besidePoints:
  case Finding::Kind::shortFoot:
    break;
  }
  return titleOf(kind);
}

} // namespace espalier
