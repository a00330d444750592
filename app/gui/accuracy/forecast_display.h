#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/gui/accuracy/forecast.h"

namespace rubble {

class CalibrationWork;
class Computation;
class Document;
class Session;
class GridDisplay;
class PanelDeck;

/// Shows in every panel with costly controls what the setting as it stands is predicted to cost, and after a run, in the Run panel,
/// what was predicted of it beside what it came to.
class ForecastDisplay : public QObject {
    Q_OBJECT

public:
    ForecastDisplay(Session& session, GridDisplay& grid, CalibrationWork& calibration, PanelDeck& deck, QObject* parent = nullptr);

    /// Figures of the last run; NaN: not measured.
    struct Measured {
        double wallSeconds;
        double liveFps;
    };
    /// A run of the scenario as it stands begins: what is said of it now is kept.
    void runBegins();
    /// It came to its end.
    void runEnded(const Measured& measured);
    /// Settings were compared: there are more points now.
    void pointsAdded();
    /// Shows what is known, in the language and units of now.
    void show();
    /// The newest answer for the scenario as it stands; unset while it is worked out.
    const std::optional<Forecast::Answer>& answer() const { return m_kept.answer; }

private:
    /// What outlives the window.
    struct Kept {
        Forecast::Learnt learnt;
        std::optional<Forecast::Answer> answer;
        std::optional<Forecast::Answer> shown;      ///< the newest, maybe of another setting
        std::optional<Scenario> runScenario;        ///< of the run whose prediction is kept, or awaited
        std::optional<Forecast::Answer> beforeRun;  ///< what was said of it
        std::optional<widgets::PredictionContent> afterRun;
        std::weak_ptr<const FeResult> of;  ///< what all of these are about
    };
    void ask();
    void said(const Forecast::Answer& answer);

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    GridDisplay& m_grid;
    CalibrationWork& m_calibration;
    PanelDeck& m_deck;
    Kept& m_kept;
    Forecast m_forecast;
};

}  // namespace rubble
