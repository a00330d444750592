#pragma once

#include <QImage>
#include <QPointF>
#include <QSize>
#include <optional>

#include "core/evidence/surveys/survey.h"

namespace rubble::widgets {

/// Heights of a survey as a picture from above, one pixel to a height, north upwards where the rows run so.
class SurveyPlan {
public:
    explicit SurveyPlan(SurveyHeights heights);

    QSize size() const;
    double spacing() const { return m_heights.spacing(); }
    /// Where a pixel lies, m, local; at the edge where it lies beyond. Unset: there is no picture.
    std::optional<Eigen::Vector2d> planAt(const QPointF& pixel) const;
    /// The surveyed place below a pixel, m, local; unset: nothing was surveyed there.
    std::optional<Vec3> placeAt(const QPointF& pixel) const;
    /// The pixel of a place, m, local; unset: it lies beyond the rows and columns.
    std::optional<QPointF> pixelOf(const Vec3& place) const;
    /// Shaded by a light from the north-west and tinted by height; clear where nothing was surveyed.
    /// @param sideMost  px; a larger one is made smaller
    QImage picture(int sideMost) const;

private:
    double heightAt(std::size_t column, std::size_t row) const { return m_heights.heights[row * m_heights.nx + column]; }
    double slopeAlong(std::size_t column, std::size_t row, bool rows) const;

    SurveyHeights m_heights;
    bool m_upwards = true;  ///< rows count upwards
    double m_across = 1.0;  ///< m, from one column to the next, and from one row to the next
    double m_along = 1.0;
};

}  // namespace rubble::widgets
