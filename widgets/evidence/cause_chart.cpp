#include "widgets/evidence/cause_chart.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/round_step.h"

namespace rubble::widgets {

namespace {

QFont boldened(QFont font) {
    font.setBold(true);
    return font;
}

/// Draws the chart into any area in any colours.
class Plot {
    Q_DECLARE_TR_FUNCTIONS(rubble::widgets::CauseChart)
public:
    Plot(const CauseComparison& made, QPainter& painter, const QRectF& area, const QFont& font, const figures::Palette& tints)
        : m_made(made), m_painter(painter), m_font(font), m_tints(tints), m_metrics(font) {
        double low = 0.0;
        double high = 0.0;
        bool begun = false;
        double names = 0.0;
        for (std::size_t rank = 0; rank < made.ranking.causes.size(); ++rank) {
            const RankedCause& cause = made.ranking.causes[rank];
            for (const double score : cause.scores) {
                if (std::isfinite(score)) {
                    low = begun ? std::min(low, score) : score;
                    high = begun ? std::max(high, score) : score;
                    begun = true;
                }
            }
            const QString name = QString::fromStdString(made.hypotheses[cause.hypothesis]);
            names = std::max({names, 1.0 + QFontMetricsF(boldened(font)).horizontalAdvance(name),
                              1.0 + m_metrics.horizontalAdvance(standingWords(made, rank))});
        }
        m_step = figures::roundStep(std::max(high - low, 1e-6), 6.0);
        m_low = m_step * std::floor(low / m_step - 0.2);
        m_high = m_step * std::ceil(high / m_step + 0.2);
        const double line = m_metrics.height();
        m_names = std::min(names, 0.35 * area.width());
        m_field = QRectF(area.left() + m_names + 1.2 * line, area.top() + 0.5 * line, 0.0, area.height() - 4.0 * line);
        m_field.setRight(area.right() - line);
        const auto rows = static_cast<double>(std::max<std::size_t>(1, made.ranking.causes.size()));
        m_row = std::min(m_field.height() / rows, 8.0 * line);
        m_field.setHeight(rows * m_row);
    }

    void paint() {
        m_painter.setFont(m_font);
        paintAxis();
        for (std::size_t r = 0; r < m_made.ranking.causes.size(); ++r) {
            paintCause(r);
        }
    }

private:
    double x(double score) const { return m_field.left() + (score - m_low) / (m_high - m_low) * m_field.width(); }

    void paintAxis() {
        const double line = m_metrics.height();
        m_painter.setRenderHint(QPainter::Antialiasing, false);
        for (double tick = m_low; tick <= m_high + 0.5 * m_step; tick += m_step) {
            m_painter.setPen(QPen(m_tints.hairline, 1.0));
            m_painter.drawLine(QPointF(x(tick), m_field.top()), QPointF(x(tick), m_field.bottom()));
            m_painter.setPen(m_tints.muted);
            const QString figure = shownNumber(std::abs(tick) < 1e-9 * m_step ? 0.0 : tick, figures::digitsOfMark(tick, m_step));
            // The last one stands within the chart.
            const double half = 0.5 * m_metrics.horizontalAdvance(figure) + 1.0;
            const double middle = std::min(x(tick), m_field.right() + line - half);
            m_painter.drawText(QRectF(middle - half, m_field.bottom() + 0.3 * line, 2.0 * half, line), Qt::AlignHCenter, figure);
        }
        const QString words = tr("departure from the evidence, in units of its scatter; less is closer");
        m_painter.drawText(QRectF(m_field.left() - m_names, m_field.bottom() + 1.7 * line, m_field.width() + m_names, 2.2 * line),
                           Qt::AlignRight | Qt::AlignTop | Qt::TextWordWrap, words);
        m_painter.setRenderHint(QPainter::Antialiasing);
    }

    void paintCause(std::size_t rank) {
        const RankedCause& cause = m_made.ranking.causes[rank];
        const double line = m_metrics.height();
        const double middle = m_field.top() + (static_cast<double>(rank) + 0.5) * m_row;
        const bool closest = rank == 0;
        // What cannot be told from the closest one has its colour, and says so below.
        const bool alike = closest || !cause.apart;
        const QColor colour = alike ? m_tints.accent : m_tints.muted;
        const double left = m_field.left() - m_names - 0.8 * line;
        const QFont bold = closest ? boldened(m_font) : m_font;
        m_painter.setFont(bold);
        m_painter.setPen(m_tints.text);
        const QString name = QString::fromStdString(m_made.hypotheses[cause.hypothesis]);
        m_painter.drawText(QRectF(left, middle - line, m_names + 0.4 * line, line), Qt::AlignLeft | Qt::AlignVCenter,
                           QFontMetricsF(bold).elidedText(name, Qt::ElideMiddle, m_names + 0.4 * line));
        m_painter.setFont(m_font);
        m_painter.setPen(m_tints.muted);
        m_painter.drawText(QRectF(left, middle, m_names + 6.0 * line, line), Qt::AlignLeft | Qt::AlignVCenter,
                           m_metrics.elidedText(standingWords(m_made, rank), Qt::ElideRight, m_names + 0.6 * line));
        m_painter.setPen(QPen(colour, 1.5));
        m_painter.drawLine(QPointF(x(cause.score.lower()), middle), QPointF(x(cause.score.upper()), middle));
        const double tall = std::min(0.32 * m_row, 0.8 * line);
        for (const double end : {cause.score.lower(), cause.score.upper()}) {
            m_painter.drawLine(QPointF(x(end), middle - 0.5 * tall), QPointF(x(end), middle + 0.5 * tall));
        }
        QColor dots = colour;
        dots.setAlphaF(0.45F);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(dots);
        for (std::size_t m = 0; m < cause.scores.size(); ++m) {
            if (std::isfinite(cause.scores[m])) {
                // Members beside each other, not over each other.
                const double off = (static_cast<double>((m * 7) % 5) - 2.0) * 0.2 * tall;
                m_painter.drawEllipse(QPointF(x(cause.scores[m]), middle + off), 0.2 * line, 0.2 * line);
            }
        }
        m_painter.setPen(QPen(m_tints.text, 2.0));
        m_painter.drawLine(QPointF(x(cause.score.middle), middle - tall), QPointF(x(cause.score.middle), middle + tall));
    }

    const CauseComparison& m_made;
    QPainter& m_painter;
    QFont m_font;
    const figures::Palette& m_tints;
    QFontMetricsF m_metrics;
    QRectF m_field;
    double m_names = 0.0;
    double m_row = 0.0;
    double m_step = 1.0;
    double m_low = 0.0;
    double m_high = 1.0;
};

}  // namespace

QString standingWords(const CauseComparison& comparison, std::size_t rank) {
    return rank == 0                               ? CauseChart::tr("closest")
           : comparison.ranking.causes[rank].apart ? CauseChart::tr("told apart")
                                                   : CauseChart::tr("not told apart");
}

CauseChart::CauseChart(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("How close each cause comes to the evidence"));
}

void CauseChart::setComparison(std::shared_ptr<const CauseComparison> comparison) {
    m_comparison = std::move(comparison);
    updateGeometry();
    describe();
    update();
}

QSize CauseChart::minimumSizeHint() const {
    const int rows = m_comparison != nullptr ? static_cast<int>(m_comparison->ranking.causes.size()) : 2;
    return {260, 60 + 34 * rows};
}

void CauseChart::describe() {
    QStringList words;
    if (m_comparison != nullptr) {
        for (std::size_t r = 0; r < m_comparison->ranking.causes.size(); ++r) {
            const RankedCause& cause = m_comparison->ranking.causes[r];
            words << tr("%1: %2, median %3")
                         .arg(QString::fromStdString(m_comparison->hypotheses[cause.hypothesis]), standingWords(*m_comparison, r),
                              shownNumber(cause.score.middle));
        }
    }
    setAccessibleDescription(inOneLine(words));
    setToolTip(words.join(u'\n'));
}

void CauseChart::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        describe();
        update();
    }
    QWidget::changeEvent(event);
}

void CauseChart::paintEvent(QPaintEvent*) {
    if (m_comparison == nullptr) {
        return;
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    Plot(*m_comparison, painter, QRectF(rect()), headingFont(), tints()).paint();
}

void CauseChart::paintFile(QPainter& painter, const QRectF& area, const QFont& font) const {
    if (m_comparison != nullptr) {
        Plot(*m_comparison, painter, area, font, figures::palette(render::Theme::Print)).paint();
    }
}

QString CauseChart::fileTitle() const {
    return tr("How close each cause comes to the evidence");
}

}  // namespace rubble::widgets
