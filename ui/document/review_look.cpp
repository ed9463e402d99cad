#include "ui/document/review_look.h"

#include <QCoreApplication>

namespace espalier {
namespace {

struct ReviewText {
  Q_DECLARE_TR_FUNCTIONS(Review)
};

} // namespace

QString titleOf(ReviewState state) {
  switch (state) {
  case ReviewState::reviewed:
    return ReviewText::tr("Reviewed");
  case ReviewState::doubtful:
    return ReviewText::tr("Doubtful");
  case ReviewState::toDo:
    break;
  }
  return ReviewText::tr("To do");
}

Color colorOf(ReviewState state, bool dark) {
  switch (state) {
  case ReviewState::reviewed:
    return dark ? Color{0x3d, 0x9d, 0xdc} : Color{0x00, 0x72, 0xb2};
  case ReviewState::doubtful:
    return dark ? Color{0xff, 0xa3, 0xd7} : Color{0x8c, 0x1f, 0x66};
  case ReviewState::toDo:
    break;
  }
  return dark ? Color{0x7d, 0x85, 0x80} : Color{0x8a, 0x90, 0x8d};
}

} // namespace espalier
