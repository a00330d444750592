#include "widgets/figures/draw.h"

#include <QPainter>

#include "widgets/figures/marks.h"
#include "widgets/figures/overlay/overlay.h"
#include "widgets/figures/palette.h"

namespace rubble::figures {

void draw(const render::View& view, render::Scene& scene, Surface& surface) {
    const QSize size = surface.pixels();
    scene.setColours(sceneColours(view.theme, view.colourMap));
    scene.update(view, size.width(), size.height());
    QPaintDevice& device = surface.drawScene();
    QPainter painter(&device);
    // Panes are in device pixels; a widget's painter is not.
    painter.scale(1.0 / device.devicePixelRatio(), 1.0 / device.devicePixelRatio());
    for (const render::Pane& pane : render::panesOf(view.layout, size.width(), size.height())) {
        paintMarks(painter, view, pane, surface.textHeight());
        paintOverlay(painter, makeOverlay(view, scene, pane), pane, view.theme, surface.textHeight());
    }
}

}  // namespace rubble::figures
