#pragma once

#include <QColor>
#include <QString>

#include <vector>

#include "widgets/render/panes.h"
#include "widgets/render/scene.h"

class QPainter;

namespace rubble::figures {

/// One line of a legend: a colour and what it stands for.
struct LegendEntry {
    QColor colour;
    QString text;
    bool outlined = false;  ///< a ring instead of a filled square, so that shape tells as well
};

/// A scale of colours beside its end values.
struct ColourBar {
    bool birthTime = true;  ///< else speed
    QString low, high;      ///< with unit
    QString title;
    render::ColourMap map = render::ColourMap::Standard;
};

/// What stands over one pane, apart from its place: made from the scene's status, painted by paintOverlay().
struct Overlay {
    QString caption;
    QString moving;  ///< what the picture leaves out while it moves; empty: nothing
    std::vector<LegendEntry> legend;
    std::vector<ColourBar> bars;  ///< none or one
    double metresPerPixel = 0.0;  ///< 0: no scale bar
};

/// What the pane of a view has to say; parts that the view switches off are empty.
Overlay makeOverlay(const render::View& view, const render::Scene& scene, const render::Pane& pane);

/// The same at its longest: once all fragments are born and structure is released.
Overlay longestOverlay(const render::View& view, const render::Scene& scene, const render::Pane& pane);

/// Paints an overlay inside a pane. The painter works in device pixels.
/// @param textHeight  of the font, device pixels
void paintOverlay(QPainter& painter, const Overlay& overlay, const render::Pane& pane, render::Theme theme, double textHeight);

/// Height that the lines above or below the model take of a pane, whichever is more, device pixels.
/// @param paneWidth  device pixels
double overlayRoom(const Overlay& overlay, double paneWidth, double textHeight);

/// Width of a scale bar with its length beside it, device pixels; 0: there is none. @param room  that it may be chosen for
double scaleLineWidth(double metresPerPixel, double room, double textHeight);
/// The same at the right end of a strip, in print colours. @return the width that it took with a gap, device pixels
double paintScaleLine(QPainter& painter, double metresPerPixel, const render::Pane& strip, double textHeight);

/// What colours stand for, without counts: for several pictures together.
std::vector<LegendEntry> commonLegend(const render::View& view, const render::SceneData& data, bool released);
/// Width of a legend in one line, device pixels.
double legendLineWidth(const std::vector<LegendEntry>& legend, const std::vector<ColourBar>& bars, double textHeight);
/// One line of a legend in print colours, in the middle of a strip.
void paintLegendLine(QPainter& painter, const std::vector<LegendEntry>& legend, const std::vector<ColourBar>& bars,
                     const render::Pane& strip, double textHeight);

}  // namespace rubble::figures
