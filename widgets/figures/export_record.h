#pragma once

#include <QSize>

#include <optional>
#include <string>
#include <vector>

#include "widgets/figures/figure_sheet.h"
#include "widgets/figures/movie.h"

namespace rubble::figures {

/// Settings of an exported figure, as they go into its provenance: one JSON object, with what a cut of the view cuts.
/// @param panel  pixels of the picture of the view
std::string settingsText(QSize pixels, double dpi, std::optional<FigurePreset> preset, QSize panel, const render::View& view,
                         const render::SceneData& data);
/// The same of a movie.
std::string settingsText(QSize pixels, const MovieSettings& settings, const render::View& view, const render::SceneData& data);

/// The view of a figure in panes of another shape: narrower ones see as far to the left and right, and more above and below.
/// @param aspect  width over height of the picture in the figure; 0: not known
/// @param width, height  of all panes together, px
render::View reshaped(const render::View& view, double aspect, int width, int height);

/// What a pane of a movie shows from its first picture to its last.
struct MoviePane {
    std::string name;     ///< "Conventional FE result"
    std::string shownAs;  ///< class, as shownAs(): between two instants where there is more than one
};
/// The panes of a movie. @param simulated  a run is shown
std::vector<MoviePane> moviePanes(const render::View& view, bool simulated);

}  // namespace rubble::figures
