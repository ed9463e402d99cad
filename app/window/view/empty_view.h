#pragma once

namespace espalier {

class ActionSet;
class PlantView;

/// Has a view that shows nothing of its plant say why, and which key changes that. Both must
/// outlive the view.
void sayWhyEmpty(PlantView& view, const ActionSet& actions);

} // namespace espalier
