#include "app/window/frame/action_set.h"
#include "app/window/view/view_options.h"
#include "core/base/error.h"
#include "ui/view/plant_view.h"

#include <QAction>
#include <QActionGroup>

namespace espalier {

void ViewOptions::setRanges(const std::map<QString, ValueRange>& ranges) {
  ColorScales scales = view_.colorScales();
  scales.ranges = ranges;
  view_.setColorScales(scales);
}

void ViewOptions::addColors() {
  const QString key = QStringLiteral("view/color");
  const auto add = [&](PointColor color, const QString& id, const QString& text,
                       const QString& help) {
    addChoice(colors_, {.id = id, .text = text, .help = help, .menu = "view/point_colors"}, key,
              [this, color] { view_.setPointColor(color); });
  };
  add(PointColor::height, "color_height", tr("Height"), tr("Colors points by their height"));
  add(PointColor::intensity, "color_intensity", tr("Intensity"),
      tr("Colors points by the strength of the echo"));
  add(PointColor::rgb, "color_rgb", tr("Own Color"), tr("Colors points as the scanner saw them"));
  add(PointColor::uniform, "color_uniform", tr("One Color"), tr("Draws all points alike"));
  const auto addValue = [&](const QString& id, const QString& text, const QString& help) {
    addChoice(colors_, {.id = id, .text = text, .help = help, .menu = "view/point_colors"}, key,
              [] {});
  }; // ValueColors follows them
  addValue("color_distance", tr("Distance to Skeleton"),
           tr("Colors points by how far they are from the surface of the wood"));
  addValue("color_displacement", tr("Displacement"),
           tr("Colors points by how far contraction moves them"));
  addValue("color_organ", tr("Organ"),
           tr("Finds what points lie on, wood, petiole, blade or needle, and colors them by it"));
  if (colors_->checkedAction() == nullptr) actions_["color_height"]->trigger();
}

void ViewOptions::addNodeColors() {
  const auto add = [this](const QString& id, const QString& text, const QString& help) {
    addChoice(nodeColors_, {.id = id, .text = text, .help = help, .menu = "view/node_colors"},
              QStringLiteral("view/node_color"), [] {});
  };
  add("node_color_none", tr("Type of Edge"), tr("Draws nodes and edges as usual"));
  add("node_color_distance", tr("Distance to Points"),
      tr("Colors nodes by how far their points are from the surface of the wood"));
  add("node_color_order", tr("Order"), tr("Colors nodes by the branchings below them"));
  add("node_color_radius", tr("Radius"), tr("Colors nodes by their radius"));
  add("node_color_radius_to_parent", tr("Radius against Parent's"),
      tr("Colors nodes by their radius as a share of their parent's"));
  add("node_color_radius_spread", tr("Uncertainty of Radius"),
      tr("Colors nodes by how wide the interval is in which their radius lies"));
  add("node_color_confidence", tr("Confidence"),
      tr("Colors nodes by how much of their surface has points"));
  add("node_color_review", tr("Review State"), tr("Colors nodes by what the review says"));
  add("node_color_comparison", tr("Comparison with Reference"),
      tr("Colors skeleton and reference by what is matched, missed, invented or wrongly attached"));
  if (nodeColors_->checkedAction() == nullptr) actions_["node_color_none"]->trigger();
}

void ViewOptions::addColorMaps() {
  const auto addTo = [this](QActionGroup* group, const QString& name, ColorMap ColorScales::*which,
                            const QString& what) {
    const auto add = [&](ColorMap map, const QString& id, const QString& text) {
      addChoice(group,
                {.id = name + "_" + id, .text = text, .help = what, .menu = "view/" + name + "s"},
                "view/" + name, [this, map, which] {
                  ColorScales scales = view_.colorScales();
                  scales.*which = map;
                  view_.setColorScales(scales);
                });
    };
    add(ColorMap::viridis, "viridis", tr("Viridis"));
    add(ColorMap::cividis, "cividis", tr("Cividis"));
    add(ColorMap::gray, "gray", tr("Gray"));
    if (group->checkedAction() == nullptr) actions_[name + "_viridis"]->trigger();
  };
  addTo(pointMaps_, "point_map", &ColorScales::points, tr("Colors of the values of points"));
  addTo(nodeMaps_, "node_map", &ColorScales::nodes, tr("Colors of the values of nodes"));
}

void ViewOptions::addColorRanges() {
  actions_.add({.id = "color_range",
                .text = tr("Type Color Range…"),
                .help = tr("Types the values at the ends of the color bar"),
                .refusal = Refusal::atPointer,
                .menu = "view/color_ranges"},
               [this] {
                 if (!view_.typeColorRange())
                   throw Error(tr("color points or nodes by a value first").toStdString());
               });
  actions_.add({.id = "usual_color_ranges",
                .text = tr("Usual Color Ranges"),
                .help = tr("Gives all color bars the range that follows from the values"),
                .menu = "view/color_ranges"},
               [this] {
                 setRanges({});
                 emit keptChanged();
               });
  QAction* seen = actions_.add(
      {.id = "colors_span_seen",
       .text = tr("Colors Span What Is Seen"),
       .help = tr("Close up, heights and intensities of the points that are seen take all colors"),
       .isCheckable = true,
       .menu = "view/color_ranges"},
      [this] {
        const bool isOn = actions_["colors_span_seen"]->isChecked();
        view_.setColorsSpanSeen(isOn);
        settings_.setValue("view/colors_span_seen", isOn);
      });
  seen->setChecked(settings_.value("view/colors_span_seen", true).toBool());
  view_.setColorsSpanSeen(seen->isChecked());
  connect(&view_, &PlantView::colorScalesChanged, this, &ViewOptions::keptChanged);
}

} // namespace espalier
