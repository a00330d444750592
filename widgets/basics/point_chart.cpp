#include "widgets/basics/point_chart.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

bool choosesPoints(int key) {
    return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space;
}

}  // namespace

PointChart::PointChart(double markReach, QWidget* parent) : QWidget(parent), m_markReach(markReach) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PointChart::choose(std::size_t) {}

void PointChart::setMarked(std::optional<std::size_t> point) {
    m_marked = point;
    describe();
    update();
}

void PointChart::describe() {
    setAccessibleDescription(m_marked ? wordsOf(*m_marked) : summary());
}

void PointChart::mark(std::optional<std::size_t> point) {
    if (point != m_marked) {
        setCursor(point && !choosingWords().isEmpty() ? Qt::PointingHandCursor : Qt::ArrowCursor);
        setMarked(point);
    }
}

QString PointChart::tipOf(std::size_t point) const {
    const QString choosing = choosingWords();
    return choosing.isEmpty() ? wordsOf(point) : wordsOf(point) + u'\n' + choosing;
}

void PointChart::paintMarks(QPainter& painter) const {
    painter.setBrush(Qt::NoBrush);
    if (m_marked) {
        const QPointF corner(m_markReach, m_markReach);
        painter.setPen(QPen(tints().text, 1.0, Qt::DotLine));
        painter.drawRect(QRectF(placeOf(*m_marked) - corner, placeOf(*m_marked) + corner));
    }
    if (hasFocus()) {
        painter.setPen(QPen(tints().accent, 1.0, Qt::DotLine));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

bool PointChart::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        // Keys that move between points are no transport here.
        const int key = static_cast<QKeyEvent*>(event)->key();
        const bool moves = key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Home || key == Qt::Key_End;
        if (moves || (key == Qt::Key_Space && !choosingWords().isEmpty())) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const auto point = pointAt(QPointF(help->pos()))) {
            QToolTip::showText(help->globalPos(), tipOf(*point), this);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    return QWidget::event(event);
}

void PointChart::mouseMoveEvent(QMouseEvent* event) {
    const auto point = pointAt(event->position());
    if (point && point != m_marked) {
        QToolTip::showText(event->globalPosition().toPoint(), tipOf(*point), this);
    }
    mark(point);
}

void PointChart::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        return;
    }
    if (const auto point = pointAt(event->position())) {
        choose(*point);
    }
}

void PointChart::leaveEvent(QEvent* event) {
    mark(std::nullopt);
    QWidget::leaveEvent(event);
}

std::optional<std::size_t> PointChart::pointBy(int key) const {
    if (pointCount() == 0) {
        return std::nullopt;
    }
    const std::size_t last = pointCount() - 1;
    switch (key) {
        case Qt::Key_Right:
            return m_marked ? std::min(*m_marked + 1, last) : 0;
        case Qt::Key_Left:
            return m_marked ? *m_marked - std::min<std::size_t>(*m_marked, 1) : last;
        case Qt::Key_Home:
            return 0;
        case Qt::Key_End:
            return last;
        default:
            return std::nullopt;
    }
}

void PointChart::keyPressEvent(QKeyEvent* event) {
    if (choosesPoints(event->key()) && m_marked && !choosingWords().isEmpty()) {
        choose(*m_marked);
    } else if (const auto point = pointBy(event->key())) {
        mark(point);
        QToolTip::showText(mapToGlobal(placeOf(*m_marked).toPoint() + QPoint(12, 12)), wordsOf(*m_marked), this);
    } else {
        QWidget::keyPressEvent(event);
    }
}

}  // namespace rubble::widgets
