#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QSize>
#include <QString>
#include <cstddef>
#include <optional>
#include <string>

#include "core/evidence/site_section.h"
#include "widgets/render/basics/view.h"

namespace rubble::figures {

/// What stands at the foot of a section that leaves the program.
struct SectionNote {
    double time = 0.0;                               ///< s, of what is cut
    Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< m: easting and northing of its begin
    Eigen::Vector2d to = Eigen::Vector2d::Zero();
    double width = 0.0;        ///< m
    std::string system = {};   ///< that these count in; empty: the model's own coordinates
    QString cautions = {};     ///< what must be known beside it; empty: nothing
    std::string provenance{};  ///< one line
};

/// How the profile of a section is drawn.
struct SectionPictureStyle {
    QSize pixels{1600, 900};
    double textPixels = 25.0;  ///< height of the text
    render::Theme theme = render::Theme::Print;
    double zero = 0.0;  ///< m, height of the local zero in the system of the case
    std::optional<SectionNote> note{};
};

/// Of how many points of a source the picture has a mark: of a dense one about 1,500, evenly along the line, of others all.
std::size_t drawnPoints(const SiteSection& section, std::size_t source);

/// Heights along a section: measured points below, each set in a mark of its own, the ground dashed, the simulated surface in
/// full, with a key, which says of how many points it draws a part. Lines end where there is no height. Below stands the note, if
/// there is one. Call ensureGuiApplication() first.
QImage sectionPicture(const SiteSection& section, const SectionPictureStyle& style);

}  // namespace rubble::figures
