#pragma once

#include <QColor>

#include <array>
#include <vector>

#include "widgets/render/basics/colours.h"
#include "widgets/render/basics/view.h"

namespace rubble::figures {

/// All colours of the program: window, views, charts and figures. One table per theme.
struct Palette {
    QColor window;        ///< behind panels
    QColor panel;         ///< panels and bars
    QColor field;         ///< editable fields
    QColor hairline;      ///< between areas
    QColor text;          ///< running text
    QColor muted;         ///< units, subtitles, axis labels
    QColor accent;        ///< selection and primary action
    QColor accentText;    ///< on accent
    QColor accentTint;    ///< selected row
    QColor fragment;      ///< vermilion, everywhere
    QColor fragmentTint;  ///< area under a curve of fragments
    QColor structure;     ///< stone grey of the active structure in legends
    QColor released;      ///< structure that was released as rigid bodies, everywhere
    QColor finding;       ///< amber
    QColor findingTint;   ///< behind a finding
    QColor error;         ///< errors only
    QColor good;          ///< good only
    QColor chip;          ///< behind captions and legends in views (may be translucent)
    QColor chipText;
    QColor skyTop, skyHorizon, ground, groundGrid;  ///< background of views
    QColor earth;                                   ///< ground in the presentation style
    QColor water;
    QColor outline;                               ///< of the intact structure
    std::array<QColor, materialCount> materials;  ///< by Material, in the presentation style
    std::vector<QColor> structureGreys;           ///< by component, in turn
    std::vector<QColor> categories;               ///< Okabe-Ito family, in turn
};

const Palette& palette(render::Theme theme);

/// Colours of fragments and active structure. In both sets the two differ in lightness and can be told apart by the colour-blind.
enum class ColourSet : std::uint8_t {
    Vermilion,  ///< fragments vermilion, structure stone grey
    Yellow,     ///< fragments yellow, structure dark grey: parted most by lightness, so in print without colour too
};
/// Which set palettes have from now on; called before drawing, on the thread that draws.
void chooseColours(ColourSet set);

/// Colour of the birth-time and the speed scale at a place in [0, 1]; lightness rises all the way, so they read in grey too.
QColor birthColour(double place, render::ColourMap map = render::ColourMap::Standard);
QColor speedColour(double place, render::ColourMap map = render::ColourMap::Standard);
/// Colour of the error scale at a place in [0, 1]; lightness falls all the way.
QColor errorColour(double place);

/// What the scene draws with, from the palette.
render::SceneColours sceneColours(render::Theme theme, render::ColourMap map = render::ColourMap::Standard);

}  // namespace rubble::figures
