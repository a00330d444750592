#include "widgets/views/stage_rail.h"

#include <QKeyEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

/// One entry: an icon or a state mark and a title, painted so that the state is told by shape as well as by colour.
class StageRail::Button : public QAbstractButton {
public:
    explicit Button(const RailEntry& entry) {
        setCheckable(true);
        setAutoExclusive(true);
        setFocusPolicy(Qt::TabFocus);
        setCursor(Qt::PointingHandCursor);
        setEntry(entry);
    }

    void setState(StageState state, std::int64_t findings, double fraction) {
        if (state == m_state && findings == m_findings && std::abs(fraction - m_fraction) < 0.005) {
            return;
        }
        m_state = state;
        m_findings = findings;
        m_fraction = fraction;
        describe();
        update();
    }
    StageState state() const { return m_state; }
    void setEntry(const RailEntry& entry) {
        m_entry = entry;
        setText(entry.title);
        setAccessibleName(entry.title);
        describe();
        update();
    }
    void setCompact(bool compact) {
        m_compact = compact;
        updateGeometry();
        update();
    }
    QSize sizeHint() const override { return m_compact ? QSize(48, 48) : QSize(136, 36); }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter p(this);
        p.setRenderHint(QPainter::Antialiasing);
        const figures::Palette& t = tints();
        if (isChecked()) {
            p.fillRect(rect(), t.accentTint);
            p.fillRect(QRectF(0, 0, 3, height()), t.accent);
        } else if (underMouse()) {
            p.fillRect(rect(), t.hairline);
        }
        if (hasFocus()) {
            p.setPen(QPen(t.accent, 1, Qt::DotLine));
            p.drawRect(QRectF(rect()).adjusted(4.5, 2.5, -2.5, -2.5));
        }
        p.setPen(m_state == StageState::NotYet && !isChecked() ? t.muted : t.text);
        if (m_compact) {
            drawGlyph(p, m_entry.glyph, QRect(13, 11, 22, 22));
            drawMark(p, QPointF(37, 35));
            return;
        }
        drawMark(p, QPointF(20, height() / 2.0));
        p.setPen(m_state == StageState::NotYet && !isChecked() ? t.muted : t.text);
        p.setFont(textFont());
        p.drawText(QRect(34, 0, width() - 36, height()), Qt::AlignVCenter | Qt::AlignLeft, m_entry.title);
    }

private:
    void describe() {
        QString state;
        switch (m_state) {
            case StageState::NotYet:
                state = StageRail::tr("not yet");
                break;
            case StageState::Running:
                state = StageRail::tr("running, %1").arg(shownShare(m_fraction, 0));
                break;
            case StageState::UpToDate:
                state = StageRail::tr("up to date");
                break;
            case StageState::Stale:
                state = StageRail::tr("stale: settings have changed since");
                break;
        }
        if (m_findings > 0) {
            state = inOneLine({state, StageRail::tr("findings: %1").arg(shownCount(m_findings))});
        }
        setToolTip(QStringLiteral("<b>%1</b><br/>%2<br/>%3").arg(m_entry.title, m_entry.question, state));
        setAccessibleDescription(state);
    }

    /// Up to date: filled; stale: ring; running: pie in the accent; not yet: hollow grey; with findings: amber.
    void drawMark(QPainter& p, const QPointF& centre) const {
        const figures::Palette& t = tints();
        const double r = 4.5;
        const QRectF circle(centre.x() - r, centre.y() - r, 2 * r, 2 * r);
        const QColor done = m_findings > 0 ? t.finding : t.good;
        p.setBrush(Qt::NoBrush);
        switch (m_state) {
            case StageState::NotYet:
                p.setPen(QPen(t.muted, 1.2));
                p.drawEllipse(circle);
                break;
            case StageState::Running:
                p.setPen(QPen(t.accent, 1.6));
                p.drawEllipse(circle);
                p.setBrush(t.accent);
                p.drawPie(circle, 90 * 16, -static_cast<int>(std::lround(360 * 16 * std::max(0.06, m_fraction))));
                break;
            case StageState::UpToDate:
                p.setPen(Qt::NoPen);
                p.setBrush(done);
                if (m_findings > 0) {
                    // A triangle, so that a finding is not told by colour alone.
                    const QPolygonF triangle({QPointF(centre.x(), centre.y() - 5.5), QPointF(centre.x() + 5.5, centre.y() + 4.5),
                                              QPointF(centre.x() - 5.5, centre.y() + 4.5)});
                    p.drawPolygon(triangle);
                } else {
                    p.drawEllipse(circle);
                }
                break;
            case StageState::Stale:
                p.setPen(QPen(t.finding, 2));
                p.drawEllipse(circle);
                break;
        }
    }

    RailEntry m_entry;
    StageState m_state = StageState::NotYet;
    std::int64_t m_findings = 0;
    double m_fraction = 0.0;
    bool m_compact = false;
};

StageRail::StageRail(const std::vector<RailEntry>& entries, QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("rail"));
    setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 8, 0, 8);
    column->setSpacing(0);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        auto* button = new Button(entries[i]);
        button->setObjectName(QStringLiteral("rail%1").arg(i));
        m_buttons.push_back(button);
        column->addWidget(button);
        connect(button, &QAbstractButton::clicked, this, [this, i] {
            m_current = static_cast<int>(i);
            emit chosen(m_current);
        });
    }
    column->addStretch();
}

void StageRail::setEntries(const std::vector<RailEntry>& entries) {
    for (std::size_t i = 0; i < std::min(entries.size(), m_buttons.size()); ++i) {
        m_buttons[i]->setEntry(entries[i]);
    }
}

void StageRail::setCurrent(int index) {
    if (index >= 0 && index < static_cast<int>(m_buttons.size())) {
        m_current = index;
        m_buttons[static_cast<std::size_t>(index)]->setChecked(true);
    }
}

void StageRail::setState(int index, StageState state, std::int64_t findings, double fraction) {
    m_buttons.at(static_cast<std::size_t>(index))->setState(state, findings, fraction);
}

StageState StageRail::state(int index) const {
    return m_buttons.at(static_cast<std::size_t>(index))->state();
}

void StageRail::setCompact(bool compact) {
    m_compact = compact;
    for (Button* button : m_buttons) {
        button->setCompact(compact);
    }
    updateGeometry();
}

void StageRail::keyPressEvent(QKeyEvent* event) {
    const int step = event->key() == Qt::Key_Down ? 1 : event->key() == Qt::Key_Up ? -1 : 0;
    const int next = m_current + step;
    if (step == 0 || next < 0 || next >= static_cast<int>(m_buttons.size())) {
        QWidget::keyPressEvent(event);
        return;
    }
    m_buttons[static_cast<std::size_t>(next)]->setFocus();
    m_buttons[static_cast<std::size_t>(next)]->click();
}

}  // namespace rubble::widgets
