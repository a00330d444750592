#include "app/gui/accuracy/forecast_display.h"

#include <cmath>

#include "app/gui/accuracy/calibration_work.h"
#include "app/gui/accuracy/grid_display.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/panel_deck.h"
#include "io/base/machine.h"

namespace rubble {

using widgets::PredictionContent;

ForecastDisplay::ForecastDisplay(Session& session, GridDisplay& grid, CalibrationWork& calibration, PanelDeck& deck,
                                 QObject* parent)
    : QObject(parent),
      m_session(session),
      m_document(session.document()),
      m_computation(session.computation()),
      m_grid(grid),
      m_calibration(calibration),
      m_deck(deck),
      m_kept(session.part<Kept>()),
      m_forecast(io::machineText(), m_kept.learnt) {
    m_forecast.setCalibration(m_calibration.calibration());
    connect(&m_grid, &GridDisplay::changed, this, &ForecastDisplay::ask);
    connect(&m_document, &Document::scenarioChanged, this, &ForecastDisplay::ask);
    connect(&m_calibration, &CalibrationWork::changed, this, [this] {
        m_forecast.setCalibration(m_calibration.calibration());
        ask();
    });
    connect(&m_forecast, &Forecast::said, this, &ForecastDisplay::said);
    if (m_kept.answer && m_kept.answer->scenario == m_document.scenario()) {
        show();
    } else {
        ask();
    }
}

void ForecastDisplay::ask() {
    const Results& results = m_computation.results();
    const auto bodies = m_grid.bodies();
    m_kept.answer.reset();
    if (m_computation.inputs().fe != nullptr && results.fragments != nullptr && !results.fragments->list.empty() && bodies) {
        m_forecast.ask(
            {m_computation.inputs(), m_document.scenario(), results.fragments, *bodies, results.components, results.clustering});
    }
    show();
}

void ForecastDisplay::said(const Forecast::Answer& answer) {
    if (m_kept.runScenario && !m_kept.beforeRun && answer.scenario == *m_kept.runScenario) {
        m_kept.beforeRun = answer;
    }
    // An older answer may rest on points or a calibration that are no longer what is known.
    if (answer.newest && answer.scenario == m_document.scenario()) {
        m_kept.answer = answer;
        show();
    }
}

void ForecastDisplay::runBegins() {
    m_kept.runScenario = m_document.scenario();
    m_kept.beforeRun = m_kept.answer;
    m_kept.afterRun.reset();
    show();
}

void ForecastDisplay::runEnded(const Measured& measured) {
    if (!m_kept.beforeRun) {
        return;
    }
    PredictionContent content;
    content.state = PredictionContent::State::Afterwards;
    content.bodies = m_kept.beforeRun->bodies;
    content.figures = m_kept.beforeRun->figures;
    bool learnt = false;
    for (widgets::PredictedFigure& figure : content.figures) {
        const double value = figure.what == Predicted::WallSeconds ? measured.wallSeconds
                             : figure.what == Predicted::Fps       ? measured.liveFps
                                                                   : std::nan("");
        figure.measured = std::isfinite(value) ? std::optional(value) : std::nullopt;
        if (figure.what == Predicted::WallSeconds && figure.measured) {
            m_forecast.learn(*m_kept.beforeRun, value);
            learnt = true;
        }
    }
    m_kept.afterRun = std::move(content);
    show();
    if (learnt) {
        ask();
    }
}

void ForecastDisplay::pointsAdded() {
    m_forecast.forgetPoints();
    ask();
}

void ForecastDisplay::show() {
    PredictionContent content;
    const std::shared_ptr<const FeResult> fe = m_computation.inputs().fe;
    const bool another = fe != m_kept.of.lock();
    m_kept.of = fe;
    if (another || fe == nullptr) {
        m_kept.answer.reset();
        m_kept.shown.reset();
        m_kept.runScenario.reset();
        m_kept.beforeRun.reset();
        m_kept.afterRun.reset();
    }
    if (fe != nullptr) {
        // Until there is an answer, the one before stays, marked as such: nothing jumps while a slider moves.
        if (m_kept.answer) {
            m_kept.shown = m_kept.answer;
        }
        content.state = m_kept.answer ? PredictionContent::State::Current : PredictionContent::State::Pending;
        content.bodies = m_kept.shown ? m_kept.shown->bodies : 0;
        content.figures = m_kept.shown ? m_kept.shown->figures : std::vector<widgets::PredictedFigure>();
    }
    std::optional<Finding> beside;
    if (m_kept.shown && m_kept.shown->beside && fe != nullptr) {
        beside = looseBesideCaution(m_kept.shown->scenario.grid.fpsTarget, *m_kept.shown->beside, fe->mesh().elementCount());
    }
    m_deck.grid().setBeside(beside);
    const bool ran = m_kept.afterRun && m_kept.runScenario == m_document.scenario();
    for (widgets::Panel* panel : m_deck.panels()) {
        panel->setPrediction(panel == &m_deck.run() && ran ? *m_kept.afterRun : content);
    }
}

}  // namespace rubble
