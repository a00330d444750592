#include "widgets/case/case_preview.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/icons.h"
#include "widgets/basics/theme.h"
#include "widgets/figures/number_text.h"

namespace rubble::widgets {

namespace {

// s of wall clock that a whole collapse takes in the preview.
constexpr double playedIn = 6.0;

std::vector<double> deathsByState(const FeResult& fe) {
    std::vector<double> deaths(fe.stateCount(), 0.0);
    for (std::size_t k = 1; k < deaths.size(); ++k) {
        const auto before = static_cast<double>(fe.activity().activeCount(k - 1));
        deaths[k] = std::max(0.0, before - static_cast<double>(fe.activity().activeCount(k)));
    }
    return deaths;
}

}  // namespace

CasePreview::CasePreview(QWidget* parent)
    : QWidget(parent),
      m_views(new ViewWidget),
      m_timeline(new Timeline),
      m_back(new QToolButton),
      m_play(new QToolButton),
      m_forward(new QToolButton),
      m_time(new QLabel) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_views, 1);
    auto* bar = new QWidget;
    bar->setObjectName(QStringLiteral("bottom"));
    bar->setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(8, 1, 0, 0);
    row->setSpacing(4);
    const auto add = [&](QToolButton* button, Glyph glyph, const QString& tip) {
        button->setIcon(glyphIcon(glyph));
        button->setToolTip(tip);
        button->setAccessibleName(tip);
        button->setFocusPolicy(Qt::StrongFocus);
        row->addWidget(button);
    };
    add(m_back, Glyph::Back, tr("Back one state"));
    add(m_play, Glyph::Play, tr("Play or pause"));
    add(m_forward, Glyph::Forward, tr("Forward one state"));
    m_time->setObjectName(QStringLiteral("previewTime"));
    m_time->setFixedWidth(m_time->fontMetrics().horizontalAdvance(QStringLiteral("0000.00 s ")));
    m_time->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(m_time);
    row->addWidget(m_timeline, 1);
    column->addWidget(bar);
    connect(m_back, &QToolButton::clicked, this, [this] { step(-1); });
    connect(m_forward, &QToolButton::clicked, this, [this] { step(1); });
    connect(m_play, &QToolButton::clicked, this, [this] {
        if (!m_clock.playing() && m_clock.time() >= m_clock.last()) {
            m_clock.setTime(m_clock.first());
        }
        m_clock.toggle();
    });
    connect(m_timeline, &Timeline::scrubbed, this, [this](double time) {
        m_clock.pause();
        m_clock.setTime(time);
    });
    connect(&m_clock, &PlaybackClock::timeChanged, this, &CasePreview::showTime);
    connect(&m_clock, &PlaybackClock::playingChanged, this,
            [this](bool playing) { m_play->setIcon(glyphIcon(playing ? Glyph::Pause : Glyph::Play)); });
    followTheme();
    setData({});
}

void CasePreview::setData(const render::SceneData& scene) {
    const bool other = scene.fe != m_views->data().fe;
    m_views->setData(scene);
    for (QToolButton* button : {m_back, m_play, m_forward}) {
        button->setEnabled(scene.fe != nullptr);
    }
    if (!other || scene.fe == nullptr) {
        return;
    }
    const FeResult& fe = *scene.fe;
    m_clock.pause();
    m_clock.setRange(fe.times().front(), fe.times().back());
    m_clock.setRate(std::max(1e-6, (fe.times().back() - fe.times().front()) / playedIn));
    m_timeline->setRange(fe.times().front(), fe.times().back());
    m_timeline->setFeEnd(fe.times().back());
    m_timeline->setDeaths(fe.times(), deathsByState(fe));
    const render::View before = m_views->view();
    render::View view = render::defaultView(scene, m_views->width(), m_views->height());
    view.layout = before.layout == render::Layout::FragmentsOnly ? render::Layout::FragmentsOnly : render::Layout::FeOnly;
    view.theme = currentTheme();
    view.time = std::clamp(m_clock.time(), m_clock.first(), m_clock.last());
    view.componentColours = before.componentColours;
    m_views->setView(view);
    m_views->fit();
    showTime();
}

void CasePreview::followTheme() {
    render::View view = m_views->view();
    view.theme = currentTheme();
    m_views->setView(view);
}

void CasePreview::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        followTheme();
    }
}

void CasePreview::mark(const std::vector<std::string>& components) {
    render::View view = m_views->view();
    view.selection.clear();
    if (const auto& known = m_views->data().components) {
        for (const Component& component : known->list) {
            if (std::find(components.begin(), components.end(), component.name) != components.end()) {
                view.selection.insert(view.selection.end(), component.elements.begin(), component.elements.end());
            }
        }
    }
    std::sort(view.selection.begin(), view.selection.end());
    m_views->setView(view);
}

void CasePreview::setFragmentsShown(bool shown) {
    render::View view = m_views->view();
    view.layout = shown ? render::Layout::FragmentsOnly : render::Layout::FeOnly;
    m_views->setView(view);
}

void CasePreview::step(int states) {
    const auto& fe = m_views->data().fe;
    if (fe == nullptr) {
        return;
    }
    m_clock.pause();
    const std::vector<double>& times = fe->times();
    // Between two states, back goes to the one before and forward to the one after.
    const auto place = states < 0 ? std::lower_bound(times.begin(), times.end(), m_clock.time())
                                  : std::upper_bound(times.begin(), times.end(), m_clock.time());
    const auto at = static_cast<std::ptrdiff_t>(place - times.begin()) + (states < 0 ? states : states - 1);
    m_clock.setTime(
        times[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at, 0, static_cast<std::ptrdiff_t>(times.size()) - 1))]);
}

void CasePreview::showTime() {
    m_views->setTime(m_clock.time());
    m_timeline->setTime(m_clock.time());
    m_time->setText(figures::timeText(m_clock.time()));
}

}  // namespace rubble::widgets
