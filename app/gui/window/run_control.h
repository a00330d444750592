#pragma once

#include <QObject>

namespace rubble {

class AccuracyDisplay;
class Actions;
class CalibrationDisplay;
class Computation;
class Document;
class ErrorDisplay;
class EvidenceStudies;
class ForecastDisplay;
class HealthDisplay;
class PanelDeck;
class SceneDisplay;
class Session;
class StatusFeed;
class ValidationDisplay;

/// Starts and ends runs, shows what came of them, and keeps work apart that would spoil each other's times.
class RunControl : public QObject {
    Q_OBJECT

public:
    /// Rooms of the window that show runs, or whose work must not run beside one.
    struct Shown {
        PanelDeck& deck;
        SceneDisplay& scene;
        HealthDisplay& health;
        ForecastDisplay& forecast;
        StatusFeed& feed;
        AccuracyDisplay& accuracy;
        CalibrationDisplay& calibration;
        ValidationDisplay& validation;
        ErrorDisplay& errors;
        EvidenceStudies& studies;
    };
    RunControl(Session& session, const Shown& shown, Actions& actions, QObject* parent = nullptr);

    void simulate(bool live);
    /// Shows the kept run that this would only repeat; where there is none, simulates.
    void showOrSimulate();
    /// What would spoil the times of other work, in words; empty: nothing runs that would.
    QString costlyWork() const;
    /// Tells each kind of work what it has to wait for.
    void showBusy();

signals:
    /// A run has begun, ended or come.
    void changed();

private:
    void cancel();
    void takeSettings();
    void runBegun();
    void runEnded(bool complete);
    void runReopened();

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    Shown m_shown;
};

}  // namespace rubble
