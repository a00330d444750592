#include "widgets/accuracy/calibration_chart.h"

#include <QPainter>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

CalibrationChart::CalibrationChart(QWidget* parent) : PointChart(CalibrationPlot::radius + 6.0, parent) {
    setAccessibleName(tr("Frames per second against the number of bodies"));
    setMarked(std::nullopt);
}

CalibrationPlot CalibrationChart::plot() const {
    return {m_content, QRectF(rect()), headingFont(), tints()};
}

QPointF CalibrationChart::placeOf(std::size_t point) const {
    const RatePoint& at = m_content.points.at(point);
    return plot().place(at.bodies, at.fps);
}

std::optional<std::size_t> CalibrationChart::pointAt(const QPointF& place) const {
    return plot().pointAt(place);
}

QString CalibrationChart::wordsOf(std::size_t point) const {
    return ratePointWords(m_content.points.at(point));
}

QString CalibrationChart::summary() const {
    return tr("%1 points. Left and Right go from point to point.").arg(m_content.points.size());
}

void CalibrationChart::setContent(CalibrationPlotContent content) {
    m_content = std::move(content);
    setMarked(std::nullopt);
}

void CalibrationChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), tints().panel);
    plot().paint(painter);
    paintMarks(painter);
}

void CalibrationChart::paintFile(QPainter& painter, const QRectF& area, const QFont& font) const {
    CalibrationPlot(m_content, area, font, figures::palette(render::Theme::Print)).paint(painter);
}

QString CalibrationChart::fileTitle() const {
    return tr("Frames per second against the number of bodies");
}

}  // namespace rubble::widgets
