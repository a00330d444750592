#pragma once

#include <QPaintDevice>
#include <QSize>
#include <QString>

#include "widgets/render/basics/view.h"
#include "widgets/render/scene.h"

namespace rubble::figures {

/// Where a view is drawn: a widget or an image. Knows how to get the scene's GL picture onto itself.
class Surface {
public:
    virtual ~Surface() = default;
    virtual QSize pixels() const = 0;       ///< device pixels
    virtual double textHeight() const = 0;  ///< of captions and legends, device pixels: 13 times the screen's scale
    /// Renders the attached scene, then returns the device to paint captions on; valid until the next call.
    virtual QPaintDevice& drawScene() = 0;
};

/// Draws a view whole: colours of its theme, scene, captions, legends, colour bar, scale bar. The one function behind window,
/// figures and movies. The scene must be attached to the surface's render window.
void draw(const render::View& view, render::Scene& scene, Surface& surface);

/// "Conventional FE result · t = 5.76 s, state 72 of 121" and its like: what the caption of a pane says.
QString captionText(render::PaneContent content, const render::PaneStatus& status);

/// A round length (1, 2 or 5 times a power of ten, m) that takes up to the given share of a pane.
double roundLength(double metresPerPixel, double maxPixels);

}  // namespace rubble::figures
