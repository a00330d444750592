#pragma once

#include <QImage>
#include <QRectF>
#include <QSize>

#include <string>

#include "core/evidence/surveys/survey_comparison.h"
#include "core/fe/control_points.h"
#include "widgets/render/basics/view.h"

class QPainter;

namespace rubble::figures {

/// How the difference map of a survey is drawn.
struct SurveyPictureStyle {
    QSize pixels{1600, 1000};
    double textPixels = 25.0;  ///< height of the text
    render::Theme theme = render::Theme::Print;
    SiteFit place;           ///< of the local frame: gives the coordinates along the edges and north
    std::string system;      ///< coordinate system that the case names; empty: none. Counts as placedSystem() says
    std::string subject{};   ///< which survey, against what, above it; empty for none
    std::string provenance;  ///< one line at the foot, empty for none
    std::string cautions{};  ///< what must be known beside it, above that; empty for none
    bool caption = true;
    bool scope = true;  ///< the polygons of what is compared are drawn
};

/// Where the cells lie on a picture.
struct SurveyField {
    QRectF frame;                                    ///< px
    Eigen::Vector2d low = Eigen::Vector2d::Zero();   ///< m, local, of its lower left corner
    Eigen::Vector2d high = Eigen::Vector2d::Zero();  ///< m, local, of its upper right corner

    QPointF toPicture(const Eigen::Vector2d& place) const;
    Eigen::Vector2d toPlace(const QPointF& point) const;
};
/// Of the picture that surveyPicture() draws in this style.
SurveyField surveyField(const SurveyComparison& made, const SurveyPictureStyle& style);

/// Draws the polygons of what is compared: the area of interest in a full line, what is left out hatched.
void drawScope(QPainter& painter, const SurveyField& field, const SurveyScope& scope, double lineWidth);

/// Simulated less surveyed debris by cells: blue where less was simulated, orange where more; the outline of the surveyed debris is
/// drawn in full, that of the simulated dashed, what is compared green, with coordinates, scale bar, the sectors' centre and a
/// legend in metres. Colours end at the 98th percentile. Call ensureGuiApplication() first.
QImage surveyPicture(const SurveyComparison& made, const SurveyPictureStyle& style);

}  // namespace rubble::figures
