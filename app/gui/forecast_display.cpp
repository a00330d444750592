#include "app/gui/forecast_display.h"

#include <cmath>

#include "app/gui/calibration_work.h"
#include "app/gui/computation.h"
#include "app/gui/document.h"
#include "app/gui/grid_display.h"
#include "app/gui/panel_deck.h"
#include "io/machine.h"

namespace rubble {

using widgets::PredictionContent;

ForecastDisplay::ForecastDisplay(Document& document, Computation& computation, GridDisplay& grid, CalibrationWork& calibration,
                                 PanelDeck& deck, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_computation(computation),
      m_grid(grid),
      m_calibration(calibration),
      m_deck(deck),
      m_forecast(io::machineText()) {
    connect(&m_grid, &GridDisplay::changed, this, &ForecastDisplay::ask);
    connect(&m_document, &Document::scenarioChanged, this, &ForecastDisplay::ask);
    connect(&m_calibration, &CalibrationWork::changed, this, [this] {
        m_forecast.setCalibration(m_calibration.calibration());
        ask();
    });
    connect(&m_forecast, &Forecast::said, this, &ForecastDisplay::said);
}

void ForecastDisplay::ask() {
    const Results& results = m_computation.results();
    const auto bodies = m_grid.bodies();
    m_answer.reset();
    if (m_computation.inputs().fe != nullptr && results.fragments != nullptr && !results.fragments->list.empty() && bodies) {
        m_forecast.ask({m_computation.inputs(), m_document.scenario(), results.fragments, *bodies});
    }
    show();
}

void ForecastDisplay::said(const Forecast::Answer& answer) {
    if (m_runScenario && !m_beforeRun && answer.scenario == *m_runScenario) {
        m_beforeRun = answer;
    }
    // An older answer may rest on points or a calibration that are no longer what is known.
    if (answer.newest && answer.scenario == m_document.scenario()) {
        m_answer = answer;
        show();
    }
}

void ForecastDisplay::runBegins() {
    m_runScenario = m_document.scenario();
    m_beforeRun = m_answer;
    m_afterRun.reset();
    show();
}

void ForecastDisplay::runEnded(const Measured& measured) {
    if (!m_beforeRun) {
        return;
    }
    PredictionContent content;
    content.state = PredictionContent::State::Afterwards;
    content.bodies = m_beforeRun->bodies;
    content.figures = m_beforeRun->figures;
    for (widgets::PredictedFigure& figure : content.figures) {
        const double value = figure.what == Predicted::WallSeconds ? measured.wallSeconds
                             : figure.what == Predicted::Fps       ? measured.liveFps
                                                                   : std::nan("");
        figure.measured = std::isfinite(value) ? std::optional(value) : std::nullopt;
    }
    m_afterRun = std::move(content);
    show();
}

void ForecastDisplay::pointsAdded() {
    m_forecast.forgetPoints();
    ask();
}

void ForecastDisplay::show() {
    PredictionContent content;
    if (m_computation.inputs().fe == nullptr) {
        m_shown.reset();
        m_runScenario.reset();
        m_beforeRun.reset();
        m_afterRun.reset();
    } else {
        // Until there is an answer, the one before stays, marked as such: nothing jumps while a slider moves.
        m_shown = m_answer ? m_answer : m_shown;
        content.state = m_answer ? PredictionContent::State::Current : PredictionContent::State::Pending;
        content.bodies = m_shown ? m_shown->bodies : 0;
        content.figures = m_shown ? m_shown->figures : std::vector<widgets::PredictedFigure>();
    }
    const bool ran = m_afterRun && m_runScenario == m_document.scenario();
    for (widgets::Panel* panel : m_deck.panels()) {
        panel->setPrediction(panel == &m_deck.run() && ran ? *m_afterRun : content);
    }
}

}  // namespace rubble
