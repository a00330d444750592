#include "widgets/accuracy_chart.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QToolTip>

#include "widgets/accuracy_words.h"
#include "widgets/theme.h"

namespace rubble::widgets {

AccuracyChart::AccuracyChart(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Cost against accuracy"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    describe();
}

AccuracyPlot AccuracyChart::plot() const {
    return {m_content, QRectF(rect()), headingFont(), tints()};
}

QPointF AccuracyChart::placeOf(std::size_t point) const {
    return plot().place(m_content.points.at(point).at);
}

void AccuracyChart::setContent(PlotContent content) {
    // The mark stays on its setting while points come in.
    const auto row = m_marked ? std::optional(m_content.points[*m_marked].row) : std::nullopt;
    m_content = std::move(content);
    m_marked.reset();
    for (std::size_t i = 0; i < m_content.points.size(); ++i) {
        if (row == m_content.points[i].row) {
            m_marked = i;
        }
    }
    describe();
    update();
}

void AccuracyChart::describe() {
    setAccessibleDescription(
        m_marked ? m_content.points[*m_marked].words
                 : tr("%1 points. Left and Right go from point to point, Enter uses the setting.").arg(m_content.points.size()));
}

void AccuracyChart::mark(std::optional<std::size_t> point) {
    if (point != m_marked) {
        m_marked = point;
        setCursor(point ? Qt::PointingHandCursor : Qt::ArrowCursor);
        describe();
        update();
    }
}

bool AccuracyChart::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        // Keys that move between points are no transport here.
        switch (static_cast<QKeyEvent*>(event)->key()) {
            case Qt::Key_Left:
            case Qt::Key_Right:
            case Qt::Key_Home:
            case Qt::Key_End:
            case Qt::Key_Space:
                event->accept();
                return true;
            default:
                break;
        }
    }
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const auto point = plot().pointAt(QPointF(help->pos()))) {
            QToolTip::showText(help->globalPos(), m_content.points[*point].words + u'\n' + tr("Click to use this setting."), this);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    return QWidget::event(event);
}

void AccuracyChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), tints().panel);
    const AccuracyPlot chart = plot();
    if (m_content.points.empty()) {
        painter.setPen(tints().muted);
        painter.setFont(textFont());
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("No setting has both figures yet. Points appear here as they are done."));
        return;
    }
    chart.paint(painter);
    if (m_marked) {
        const double reach = AccuracyPlot::radius + 8.0;
        const QPointF at = chart.place(m_content.points[*m_marked].at);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(tints().text, 1.0, Qt::DotLine));
        painter.drawRect(QRectF(at - QPointF(reach, reach), QSizeF(2.0 * reach, 2.0 * reach)));
    }
    if (hasFocus()) {
        painter.setPen(QPen(tints().accent, 1.0, Qt::DotLine));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void AccuracyChart::mouseMoveEvent(QMouseEvent* event) {
    const auto point = plot().pointAt(event->position());
    if (point && point != m_marked) {
        QToolTip::showText(event->globalPosition().toPoint(),
                           m_content.points[*point].words + u'\n' + tr("Click to use this setting."), this);
    }
    mark(point);
}

void AccuracyChart::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        return;
    }
    if (const auto point = plot().pointAt(event->position())) {
        emit rowChosen(m_content.points[*point].row);
    }
}

void AccuracyChart::leaveEvent(QEvent* event) {
    mark(std::nullopt);
    QWidget::leaveEvent(event);
}

void AccuracyChart::keyPressEvent(QKeyEvent* event) {
    const auto count = m_content.points.size();
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space;
    if (enter && m_marked) {
        emit rowChosen(m_content.points[*m_marked].row);
    } else if (count > 0 && event->key() == Qt::Key_Right) {
        mark(m_marked ? std::min(*m_marked + 1, count - 1) : 0);
    } else if (count > 0 && event->key() == Qt::Key_Left) {
        mark(m_marked ? *m_marked - std::min<std::size_t>(*m_marked, 1) : count - 1);
    } else if (count > 0 && event->key() == Qt::Key_Home) {
        mark(0);
    } else if (count > 0 && event->key() == Qt::Key_End) {
        mark(count - 1);
    } else {
        QWidget::keyPressEvent(event);
        return;
    }
    if (m_marked && !enter) {
        QToolTip::showText(mapToGlobal(placeOf(*m_marked).toPoint() + QPoint(12, 12)), m_content.points[*m_marked].words, this);
    }
}

void AccuracyChart::paintFile(QPainter& painter, const QRectF& area, const QFont& font) const {
    AccuracyPlot(m_content, area, font, figures::palette(render::Theme::Print)).paint(painter);
}

QString AccuracyChart::fileTitle() const {
    return tr("What accuracy costs");
}

}  // namespace rubble::widgets
