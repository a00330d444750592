#include "widgets/calibration_chart.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "widgets/theme.h"

namespace rubble::widgets {

CalibrationChart::CalibrationChart(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Frames per second against the number of bodies"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    describe();
}

CalibrationPlot CalibrationChart::plot() const {
    return {m_content, QRectF(rect()), headingFont(), tints()};
}

QPointF CalibrationChart::placeOf(std::size_t point) const {
    const RatePoint& at = m_content.points.at(point);
    return plot().place(at.bodies, at.fps);
}

void CalibrationChart::setContent(CalibrationPlotContent content) {
    m_content = std::move(content);
    m_marked.reset();
    describe();
    update();
}

void CalibrationChart::describe() {
    setAccessibleDescription(m_marked ? ratePointWords(m_content.points[*m_marked])
                                      : tr("%1 points. Left and Right go from point to point.").arg(m_content.points.size()));
}

void CalibrationChart::mark(std::optional<std::size_t> point) {
    if (point != m_marked) {
        m_marked = point;
        describe();
        update();
    }
}

bool CalibrationChart::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const auto point = plot().pointAt(QPointF(help->pos()))) {
            QToolTip::showText(help->globalPos(), ratePointWords(m_content.points[*point]), this);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    return QWidget::event(event);
}

void CalibrationChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), tints().panel);
    const CalibrationPlot chart = plot();
    chart.paint(painter);
    if (m_marked) {
        const double reach = CalibrationPlot::radius + 6.0;
        const RatePoint& point = m_content.points[*m_marked];
        const QPointF at = chart.place(point.bodies, point.fps);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(tints().text, 1.0, Qt::DotLine));
        painter.drawRect(QRectF(at - QPointF(reach, reach), QSizeF(2.0 * reach, 2.0 * reach)));
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(tints().accent, 1.0, Qt::DotLine));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void CalibrationChart::mouseMoveEvent(QMouseEvent* event) {
    const auto point = plot().pointAt(event->position());
    if (point && point != m_marked) {
        QToolTip::showText(event->globalPosition().toPoint(), ratePointWords(m_content.points[*point]), this);
    }
    mark(point);
}

void CalibrationChart::leaveEvent(QEvent* event) {
    mark(std::nullopt);
    QWidget::leaveEvent(event);
}

void CalibrationChart::keyPressEvent(QKeyEvent* event) {
    const std::size_t count = m_content.points.size();
    if (count > 0 && event->key() == Qt::Key_Right) {
        mark(m_marked ? std::min(*m_marked + 1, count - 1) : 0);
    } else if (count > 0 && event->key() == Qt::Key_Left) {
        mark(m_marked ? *m_marked - std::min<std::size_t>(*m_marked, 1) : count - 1);
    } else {
        QWidget::keyPressEvent(event);
        return;
    }
    QToolTip::showText(mapToGlobal(placeOf(*m_marked).toPoint() + QPoint(12, 12)), ratePointWords(m_content.points[*m_marked]),
                       this);
}

void CalibrationChart::paintFile(QPainter& painter, const QRectF& area, const QFont& font) const {
    CalibrationPlot(m_content, area, font, figures::palette(render::Theme::Print)).paint(painter);
}

QString CalibrationChart::fileTitle() const {
    return tr("Frames per second against the number of bodies");
}

}  // namespace rubble::widgets
