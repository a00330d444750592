#include "widgets/accuracy/accuracy_chart.h"

#include <QPainter>

#include "widgets/basics/theme.h"

namespace rubble::widgets {

AccuracyChart::AccuracyChart(QWidget* parent) : PointChart(AccuracyPlot::radius + 8.0, parent) {
    setAccessibleName(tr("Cost against accuracy"));
    setMarked(std::nullopt);
}

AccuracyPlot AccuracyChart::plot() const {
    return {m_content, QRectF(rect()), headingFont(), tints()};
}

QPointF AccuracyChart::placeOf(std::size_t point) const {
    return plot().place(m_content.points.at(point).at);
}

std::optional<std::size_t> AccuracyChart::pointAt(const QPointF& place) const {
    return plot().pointAt(place);
}

QString AccuracyChart::wordsOf(std::size_t point) const {
    return m_content.points.at(point).words;
}

QString AccuracyChart::summary() const {
    return tr("%1 points. Left and Right go from point to point, Enter uses the setting.").arg(m_content.points.size());
}

QString AccuracyChart::choosingWords() const {
    return tr("Click to use this setting.");
}

void AccuracyChart::choose(std::size_t point) {
    emit rowChosen(m_content.points.at(point).row);
}

void AccuracyChart::setContent(PlotContent content) {
    // The mark stays on its setting while points come in.
    const auto row = marked() ? std::optional(m_content.points[*marked()].row) : std::nullopt;
    m_content = std::move(content);
    std::optional<std::size_t> same;
    for (std::size_t i = 0; i < m_content.points.size(); ++i) {
        if (row == m_content.points[i].row) {
            same = i;
        }
    }
    setMarked(same);
}

void AccuracyChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), tints().panel);
    if (m_content.points.empty()) {
        painter.setPen(tints().muted);
        painter.setFont(textFont());
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("No setting has both figures yet. Points appear here as they are done."));
        return;
    }
    plot().paint(painter);
    paintMarks(painter);
}

void AccuracyChart::paintFile(QPainter& painter, const QRectF& area, const QFont& font) const {
    AccuracyPlot(m_content, area, font, figures::palette(render::Theme::Print)).paint(painter);
}

QString AccuracyChart::fileTitle() const {
    return tr("What accuracy costs");
}

}  // namespace rubble::widgets
