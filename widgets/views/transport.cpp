#include "widgets/views/transport.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <array>
#include <cmath>

#include "widgets/basics/icons.h"
#include "widgets/basics/theme.h"
#include "widgets/figures/number_text.h"

namespace rubble::widgets {

namespace {

constexpr std::array rates = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0};

QToolButton* button(Glyph glyph, const QString& name, const QString& tip) {
    auto* made = new QToolButton;
    made->setIcon(glyphIcon(glyph));
    made->setAccessibleName(name);
    made->setToolTip(tip);
    made->setFocusPolicy(Qt::TabFocus);
    return made;
}

}  // namespace

Transport::Transport(QWidget* parent)
    : QWidget(parent),
      m_time(new QLabel),
      m_span(new QLabel),
      m_play(button(Glyph::Play, tr("Play"), {})),
      m_playBack(button(Glyph::PlayBack, tr("Play backwards"), {})),
      m_loop(
          button(Glyph::Loop, tr("Loop"), tr("Playback goes round: the range dragged with Shift in the timeline, or all of it"))),
      m_rate(new QComboBox) {
    setObjectName(QStringLiteral("transportBar"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 8, 8, 8);
    column->setSpacing(6);
    auto* figures = new QHBoxLayout;
    m_time->setFont(largeFigureFont());
    m_time->setObjectName(QStringLiteral("timeFigures"));
    m_span->setObjectName(QStringLiteral("muted"));
    m_span->setFont(headingFont());
    m_span->setWordWrap(true);
    figures->addWidget(m_time);
    figures->addWidget(m_span, 1, Qt::AlignBottom);
    column->addLayout(figures);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    QToolButton* first = button(Glyph::First, tr("First instant"), tr("To the first instant (Home)"));
    QToolButton* back = button(Glyph::Back, tr("Back"), tr("Back one state (←), ten with Shift"));
    QToolButton* forward = button(Glyph::Forward, tr("Forward"), tr("Forward one state (→), ten with Shift"));
    QToolButton* last = button(Glyph::Last, tr("Last instant"), tr("To the last instant (End)"));
    m_play->setObjectName(QStringLiteral("play"));
    QToolButton* bookmark = button(Glyph::Bookmark, tr("Bookmark"), tr("Mark this instant with a note (B)"));
    bookmark->setObjectName(QStringLiteral("bookmark"));
    m_playBack->setObjectName(QStringLiteral("playBack"));
    m_loop->setObjectName(QStringLiteral("loop"));
    m_loop->setCheckable(true);
    for (QToolButton* each : {first, back, m_playBack, m_play, forward, last}) {
        buttons->addWidget(each);
    }
    offerRates();
    m_rate->setToolTip(tr("Playback rate: seconds of collapse per second"));
    m_rate->setAccessibleName(tr("Playback rate"));
    m_rate->setFocusPolicy(Qt::TabFocus);
    buttons->addWidget(m_rate);
    buttons->addWidget(m_loop);
    buttons->addWidget(bookmark);
    buttons->addStretch();
    column->addLayout(buttons);
    column->addStretch();

    connect(first, &QToolButton::clicked, this, &Transport::jumpedToFirst);
    connect(last, &QToolButton::clicked, this, &Transport::jumpedToLast);
    connect(back, &QToolButton::clicked, this, [this] { emit stepped(-1); });
    connect(forward, &QToolButton::clicked, this, [this] { emit stepped(1); });
    connect(m_play, &QToolButton::clicked, this, &Transport::playToggled);
    connect(m_playBack, &QToolButton::clicked, this, &Transport::playBackToggled);
    connect(m_loop, &QToolButton::clicked, this, &Transport::loopToggled);
    connect(bookmark, &QToolButton::clicked, this, &Transport::bookmarkRequested);
    connect(m_rate, &QComboBox::activated, this, [this] { emit ratePicked(m_rate->currentData().toDouble()); });
    setRate(1.0);
    setPlaying(false);
    setTime(0.0);
}

void Transport::setTime(double time) {
    m_shown = time;
    m_time->setText(figures::timeText(time - m_origin));
}

double Transport::usualRate() {
    const double perSi = figures::timeUnit().perSi;
    return perSi > 1.0 ? 10.0 / perSi : 1.0;
}

// Of a brief result in its own units of time a second, and those of what comes after it.
void Transport::offerRates() {
    m_offered = usualRate();
    m_rate->clear();
    if (m_offered < 1.0) {
        for (const double rate : rates) {
            m_rate->addItem(figures::paceText(rate * m_offered), rate * m_offered);
        }
    }
    for (const double rate : rates) {
        m_rate->addItem(figures::paceText(rate), rate);
    }
}

void Transport::setSpan(double last, double feEnd, bool looseBodies) {
    if (m_offered != usualRate()) {
        offerRates();
        emit ratePicked(m_offered);
    }
    m_last = last;
    m_feEnd = feEnd;
    const QString end = tr("of %1").arg(figures::timeText(last - m_origin));
    const QString until = (looseBodies ? tr("all let go by %1") : tr("FE ends at %1")).arg(figures::timeText(feEnd - m_origin));
    m_span->setText(last > feEnd + 1e-9 ? end + QLatin1Char('\n') + until : end);
}

void Transport::setTimeOrigin(double origin) {
    m_origin = origin;
    setTime(m_shown);
    setSpan(m_last, m_feEnd);
}

void Transport::setPlaying(bool playing) {
    m_playing = playing;
    const bool forwards = playing && !m_backwards;
    const bool back = playing && m_backwards;
    m_play->setIcon(glyphIcon(forwards ? Glyph::Pause : Glyph::Play));
    m_play->setToolTip(forwards ? tr("Pause (Space)") : tr("Play (Space)"));
    m_play->setAccessibleName(forwards ? tr("Pause") : tr("Play"));
    m_playBack->setIcon(glyphIcon(back ? Glyph::Pause : Glyph::PlayBack));
    m_playBack->setToolTip(back ? tr("Pause (Shift+Space)") : tr("Play backwards (Shift+Space)"));
    m_playBack->setAccessibleName(back ? tr("Pause") : tr("Play backwards"));
}

void Transport::setBackwards(bool backwards) {
    m_backwards = backwards;
    setPlaying(m_playing);
}

void Transport::setLooping(bool looping) {
    m_loop->setChecked(looping);
}

void Transport::setRate(double rate) {
    for (int i = 0; i < m_rate->count(); ++i) {
        if (std::abs(m_rate->itemData(i).toDouble() - rate) < 1e-6 * rate) {
            m_rate->setCurrentIndex(i);
        }
    }
}

void Transport::setAvailable(bool available) {
    setEnabled(available);
}

}  // namespace rubble::widgets
