#include "widgets/render/panes.h"

#include <algorithm>

#include "widgets/render/basics/camera.h"

namespace rubble::render {

std::vector<Pane> panesOf(Layout layout, int width, int height, int gap) {
    width = std::max(width, 1);
    height = std::max(height, 1);
    switch (layout) {
        case Layout::FeOnly:
            return {{PaneContent::Fe, 0, 0, width, height}};
        case Layout::FragmentsOnly:
            return {{PaneContent::Fragments, 0, 0, width, height}};
        case Layout::OverlayOnly:
            return {{PaneContent::Overlay, 0, 0, width, height}};
        case Layout::Four: {
            const int left = std::max((width - gap) / 2, 1);
            const int top = std::max((height - gap) / 2, 1);
            const int right = std::max(width - gap - left, 1);
            const int bottom = std::max(height - gap - top, 1);
            return {{PaneContent::Fe, 0, 0, left, top},
                    {PaneContent::Fragments, left + gap, 0, right, top},
                    {PaneContent::Overlay, 0, top + gap, left, bottom},
                    {PaneContent::Plan, left + gap, top + gap, right, bottom}};
        }
        case Layout::Stacked: {
            const int first = std::max((height - gap) / 2, 1);
            return {{PaneContent::Fe, 0, 0, width, first},
                    {PaneContent::Fragments, 0, first + gap, width, std::max(height - gap - first, 1)}};
        }
        case Layout::Scenarios:
        case Layout::Beside:
            break;
    }
    const bool scenarios = layout == Layout::Scenarios;
    const int first = std::max((width - gap) / 2, 1);
    return {{scenarios ? PaneContent::Fragments : PaneContent::Fe, 0, 0, first, height},
            {scenarios ? PaneContent::Other : PaneContent::Fragments, first + gap, 0, std::max(width - gap - first, 1), height}};
}

std::optional<Pane> paneAt(Layout layout, int width, int height, int x, int y) {
    for (const Pane& pane : panesOf(layout, width, height)) {
        if (pane.contains(x, y)) {
            return pane;
        }
    }
    return std::nullopt;
}

Layout suggestLayout(const Aabb& bounds, int width, int height) {
    if (bounds.isEmpty()) {
        return Layout::Beside;
    }
    // The layout in which the model comes out larger: fit it into a pane of each.
    const auto pixelsPerMetre = [&](Layout layout) {
        const Pane pane = panesOf(layout, width, height).front();
        return 1.0 / metresPerPixel(fitCamera(bounds, pane.aspect()), pane.height);
    };
    return pixelsPerMetre(Layout::Stacked) > pixelsPerMetre(Layout::Beside) ? Layout::Stacked : Layout::Beside;
}

}  // namespace rubble::render
