#pragma once

#include <QCoreApplication>
#include <QPainter>
#include <optional>
#include <utility>
#include <vector>

#include "core/analysis/accuracy/accuracy_front.h"
#include "widgets/basics/chart_axis.h"
#include "widgets/figures/palette.h"

namespace rubble::widgets {

/// The row of a sweep that is the reference itself; others are numbers of its settings.
inline constexpr int referenceRow = -1;

/// One point of the chart.
struct PlotPoint {
    int row = referenceRow;
    QString name;
    QString words;  ///< all its numbers
    CostAccuracy at;
    std::optional<std::pair<double, double>> range;  ///< of the accuracy, over it and its own repeats
    bool front = false;                              ///< on the Pareto front
    bool published = false;                          ///< the published method: a square
    bool inUse = false;
};

/// What a chart of cost against accuracy shows.
struct PlotContent {
    CostKind cost = CostKind::StepMean;
    AccuracyKind accuracy;
    std::vector<PlotPoint> points;  ///< those that have both figures, by rising cost
    std::size_t left = 0;           ///< settings without a figure of the two
    std::optional<std::pair<double, double>> band;
    std::optional<double> target;  ///< on the axis of cost
    double fpsTarget = 0.0;
};

/// @param inUse  the row that is the current setting
/// @param fpsTarget  frames per second
PlotContent plotContent(const AccuracyReport& report, CostKind cost, const AccuracyKind& accuracy, std::optional<int> inUse,
                        double fpsTarget);

/// Lays a chart out in a rectangle and draws it, on a screen or for a file.
class AccuracyPlot {
    Q_DECLARE_TR_FUNCTIONS(rubble::widgets::AccuracyPlot)
public:
    /// @param font  of labels; its size decides the margins
    AccuracyPlot(const PlotContent& content, const QRectF& area, const QFont& font, const figures::Palette& palette);

    void paint(QPainter& painter) const;
    QPointF place(const CostAccuracy& at) const;
    const QRectF& frame() const { return m_field.frame; }
    /// The point nearest to a place, no further than a finger's width.
    std::optional<std::size_t> pointAt(const QPointF& place) const;

    static constexpr double radius = 5.0;  ///< px, of a point

private:
    ChartAxis costAxis() const;
    ChartAxis accuracyAxis() const;
    void paintAxes(QPainter& painter) const;
    void paintBand(QPainter& painter) const;
    void paintTarget(QPainter& painter, std::vector<QRectF>& taken) const;
    QPolygonF targetLine() const;
    QPolygonF frontLine() const;
    void paintFront(QPainter& painter) const;
    void paintSpread(QPainter& painter, const PlotPoint& point, std::vector<QRectF>& taken) const;
    void paintPoint(QPainter& painter, const PlotPoint& point) const;
    void paintNames(QPainter& painter, std::vector<QRectF>& taken) const;

    const PlotContent& m_content;
    QFont m_font;
    const figures::Palette& m_palette;
    ChartField m_field;
};

}  // namespace rubble::widgets
