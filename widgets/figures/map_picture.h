#pragma once

#include <QImage>
#include <QPointF>
#include <QRectF>
#include <QSize>
#include <array>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/outline.h"
#include "core/evidence/maps/debris_map.h"
#include "core/fe/control_points.h"
#include "core/fe/orthophoto.h"
#include "widgets/render/basics/view.h"

namespace rubble::figures {

/// A place of a map with a ring around it.
struct MapRing {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< m
    double radius = 0.0;                               ///< m
};

/// A line around something on a map: the structure that stood there, or what was found.
struct MapOutline {
    /// What stood there, what still stands, what was found, what looks like evidence and was simulated, the area that is compared.
    enum class Of : std::uint8_t { Structure, Standing, Evidence, Simulated, Area };
    static constexpr std::array<Of, 5> all{Of::Structure, Of::Standing, Of::Evidence, Of::Simulated, Of::Area};
    Of of = Of::Structure;
    std::vector<OutlineRing> rings;  ///< m, local
};

/// How a map is drawn.
struct MapPictureStyle {
    QSize pixels{1600, 1000};
    double dpi = 200.0;               ///< decides the size of text: 9 pt
    SiteFit place;                    ///< of the local frame: gives the coordinates along the edges and north
    std::string system;               ///< coordinate system that the case names; empty: none. Counts as placedSystem() says
    std::string shown = "simulated";  ///< class of what is shown
    std::string provenance;           ///< one line in 6 pt at the foot, empty for none
    std::string cautions{};           ///< what must be known beside it, above that; empty for none
    render::Theme theme = render::Theme::Print;
    std::optional<MapRing> ring;
    double contours = 0.0;               ///< m, between lines of equal height; 0: none. Of maps that have heights
    std::vector<MapOutline> outlines{};  ///< the picture reaches as far as those of the structure
    std::string subject{};               ///< what it is a map of, above it, with the sums of its debris; empty: neither
    bool shownUnits = false;             ///< legend, scale bar and words count as the window does; a file counts in SI
    bool fitted = false;                 ///< the picture is made as low or as narrow as the map; `pixels` is the most
};

/// Where the cells of a map lie in its picture.
struct MapPlacing {
    QRectF cells;                                   ///< px, of the cells shown
    Eigen::Vector2d low = Eigen::Vector2d::Zero();  ///< m, local, of their lower left corner
    double metres = 1.0;                            ///< m, that a pixel covers

    Eigen::Vector2d at(const QPointF& pixel) const;  ///< m, local
};

/// One layer of a map, on white for print, with scale bar, arrow to the north, coordinates along the edges, legend with unit, and a
/// caption below; fallen live structure is drawn in grey where no fragments lie, if the map has it. Shown is what holds 99.9 % of
/// the mass, if the rest lies far from it; the caption then counts the cells left out. Colours end at the 99th percentile. Call
/// ensureGuiApplication() first. Throws UsageError for a size out of range or a layer that the map does not have.
/// @param placing  where its cells lie in the picture; null: not asked for
QImage mapPicture(const DebrisMap& map, MapLayer layer, const MapPictureStyle& style, MapPlacing* placing = nullptr);

/// One layer of a map to be laid on the ground of the views: a pixel for each cell in the colours of mapPicture(), nothing where
/// there is no value. Throws UsageError for a layer that the map does not have.
Orthophoto groundPicture(const DebrisMap& map, MapLayer layer);

}  // namespace rubble::figures
