#pragma once

#include <optional>
#include <vector>

#include "widgets/render/basics/view.h"

namespace rubble::render {

/// A pane of a view in device pixels, y downwards from the top.
struct Pane {
    PaneContent content = PaneContent::Fe;
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool contains(int px, int py) const { return px >= x && px < x + width && py >= y && py < y + height; }
    double aspect() const { return height > 0 ? static_cast<double>(width) / height : 1.0; }
};

/// The panes of a layout, in order FE, fragments, overlay, plan, another scenario, with a gap of one hairline between them.
std::vector<Pane> panesOf(Layout layout, int width, int height, int gap = 1);
/// The pane that holds a pixel.
std::optional<Pane> paneAt(Layout layout, int width, int height, int x, int y);
/// Stacked for models that are long beside their height (seen as by the Side preset), Beside otherwise.
Layout suggestLayout(const Aabb& bounds, int width, int height);

}  // namespace rubble::render
