#include "app/window/view/empty_view.h"

#include "app/window/frame/action_set.h"
#include "app/window/frame/key_hints.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QCoreApplication>

namespace espalier {
namespace {

QString wordFor(InView seen, const ActionSet& actions) {
  const auto tr = [](const char* text) {
    return QCoreApplication::translate("espalier::EmptyView", text);
  };
  switch (seen) {
  case InView::plant:
    return {};
  case InView::layersOff:
    return tr(QT_TRANSLATE_NOOP("espalier::EmptyView",
                                "All layers are off: choose one in View > Layers"));
  case InView::clipped:
    return withKeys(tr(QT_TRANSLATE_NOOP("espalier::EmptyView",
                                         "Nothing lies in the slab or the box of Clipping here.   "
                                         "{show_all} shows all of the plant")),
                    actions);
  case InView::hidden:
    if (!actions["show_all"]->isEnabled()) // points alone
      return tr(QT_TRANSLATE_NOOP(
          "espalier::EmptyView", "The points that are here are set aside, or hidden as explained"));
    return withKeys(tr(QT_TRANSLATE_NOOP("espalier::EmptyView",
                                         "What is here is hidden.   {show_all} shows all of the "
                                         "plant")),
                    actions);
  case InView::beside:
    return withKeys(
        tr(QT_TRANSLATE_NOOP("espalier::EmptyView",
                             "The plant is not in view.   {frame_all} shows all of it")),
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
