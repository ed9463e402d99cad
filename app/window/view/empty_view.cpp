#include "app/window/view/empty_view.h"

#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QCoreApplication>

namespace espalier {
namespace {

struct EmptyViewText {
  Q_DECLARE_TR_FUNCTIONS(EmptyView)
};

QString wordFor(InView seen, const ActionSet& actions) {
  switch (seen) {
  case InView::plant:
    return {};
  case InView::layersOff:
    return EmptyViewText::tr("All layers are off: choose one in View > Layers");
  case InView::clipped:
    return withKeys(EmptyViewText::tr("Nothing lies in the slab or the box of Clipping here.   "
                                      "{show_all} shows all of the plant"),
                    actions);
  case InView::hidden:
    if (!actions["show_all"]->isEnabled()) // points alone
      return EmptyViewText::tr("The points that are here are set aside, or hidden as explained");
    return withKeys(EmptyViewText::tr("What is here is hidden.   {show_all} shows all of the "
                                      "plant"),
                    actions);
  case InView::beside:
    return withKeys(EmptyViewText::tr("The plant is not in view.   {frame_all} shows all of it"),
                    actions);
  }
  return {};
}

} // namespace

void sayWhyEmpty(PlantView& view, const ActionSet& actions) {
  QObject::connect(&view, &PlantView::settled, &view,
                   [&view, &actions] { view.setWord(wordFor(view.inView(), actions)); });
}

} // namespace espalier
