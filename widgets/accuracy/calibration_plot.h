#pragma once

#include <QCoreApplication>
#include <QFont>
#include <QRectF>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/analysis/accuracy/calibration.h"
#include "widgets/basics/chart_axis.h"
#include "widgets/figures/palette.h"

class QPainter;

namespace rubble::widgets {

/// One measured rate of the chart, or one of the published ones.
struct RatePoint {
    std::optional<PileKind> pile;  ///< unset: published
    LiveLoad load = LiveLoad::Both;
    double bodies = 0.0;
    double fps = 0.0;
};

/// The fitted curve of one pile under one load, with its 80 % interval.
struct RateCurve {
    struct Place {
        double bodies = 0.0;
        FitInterval fps;
    };
    PileKind pile = PileKind::Typical;
    LiveLoad load = LiveLoad::Both;
    std::vector<Place> places;  ///< by rising bodies; none with too few points
};

/// What the chart of live FPS against the number of bodies shows.
struct CalibrationPlotContent {
    double target = 24.0;           ///< frames per second
    std::vector<RatePoint> points;  ///< measured ones first, then the published
    std::vector<RateCurve> curves;
    /// N_A^max by pile: where simulating and drawing together keep the target.
    std::array<std::optional<Calibration::BodiesMax>, 2> bodiesMax;
};

/// Fits the curves; takes a while, so not on the thread of the window. @param calibration  null: the published points alone
CalibrationPlotContent calibrationPlotContent(const Calibration* calibration, double target);

/// "typical pile, physics alone"
QString curveWords(PileKind pile, LiveLoad load);
/// Rounded to the two digits that the fit can mean: down, or up where it is only known that there are fewer.
std::int64_t roundedBodies(const Calibration::BodiesMax& most);
/// "3,100", "over 6,000"
QString bodiesWords(const Calibration::BodiesMax& most);
/// All figures of a point: what the chart says on hover and reads aloud.
QString ratePointWords(const RatePoint& point);

/// Lays the chart out in a rectangle and draws it, on a screen or for a file. Both axes are logarithmic.
class CalibrationPlot {
    Q_DECLARE_TR_FUNCTIONS(rubble::widgets::CalibrationPlot)
public:
    CalibrationPlot(const CalibrationPlotContent& content, const QRectF& area, const QFont& font, const figures::Palette& palette);

    void paint(QPainter& painter) const;
    QPointF place(double bodies, double fps) const;
    const QRectF& frame() const { return m_field.frame; }
    /// The point nearest to a place, no further than a finger's width.
    std::optional<std::size_t> pointAt(const QPointF& place) const;

    static constexpr double radius = 4.0;  ///< px, of a point

private:
    QColor colourOf(LiveLoad load) const;
    void settleAxes();
    void paintAxes(QPainter& painter) const;
    void paintCurve(QPainter& painter, const RateCurve& curve) const;
    void paintPoint(QPainter& painter, const RatePoint& point) const;
    void paintTarget(QPainter& painter, std::vector<QRectF>& taken) const;
    void paintNames(QPainter& painter, std::vector<QRectF>& taken) const;
    /// Writes words at the first of some places that is free; nothing where none is.
    void write(QPainter& painter, const QString& words, const QColor& colour, const std::vector<QPointF>& corners,
               std::vector<QRectF>& taken) const;

    const CalibrationPlotContent& m_content;
    QFont m_font;
    const figures::Palette& m_palette;
    ChartField m_field;
};

}  // namespace rubble::widgets
