#pragma once

#include <QImage>
#include <QSize>

#include <string>

#include "core/evidence/surveys/survey_comparison.h"
#include "core/fe/control_points.h"
#include "widgets/render/basics/view.h"

class QPainter;
class QRectF;

namespace rubble::figures {

/// How the difference map of a survey is drawn.
struct SurveyPictureStyle {
    QSize pixels{1600, 1000};
    double textPixels = 25.0;  ///< height of the text
    render::Theme theme = render::Theme::Print;
    SiteFit place;           ///< of the local frame: gives the coordinates along the edges and north
    std::string system;      ///< coordinate system, for people; empty: local
    std::string provenance;  ///< one line at the foot, empty for none
    bool caption = true;
};

/// Simulated less surveyed debris by cells: blue where less was simulated, orange where more; the outline of the surveyed debris is
/// drawn in full, that of the simulated dashed, with coordinates, scale bar, the sectors' centre and a legend in metres. Colours
/// end at the 98th percentile. Call ensureGuiApplication() first.
QImage surveyPicture(const SurveyComparison& made, const SurveyPictureStyle& style);

}  // namespace rubble::figures
