#pragma once

#include <QObject>
#include <QPointer>

class QDialog;
class QWidget;

namespace rubble {

class Computation;
class Document;
class Session;
class RunHistory;
namespace widgets {
class RunList;
class ScenarioComparison;
class ScenarioList;
}  // namespace widgets

/// Brings the scenarios and the runs of the case into their lists, and what is done there into the document.
class ScenariosDisplay : public QObject {
    Q_OBJECT

public:
    ScenariosDisplay(Session& session, widgets::ScenarioList& scenarios, widgets::RunList& runs, QWidget& window);

    ~ScenariosDisplay() override;

    void refresh();
    /// Shows two scenarios side by side in a window of its own.
    void compare();
    /// Null until compare() was called.
    widgets::ScenarioComparison* comparison() const { return m_comparison; }

private:
    /// What outlives the window.
    struct Kept {
        bool comparing = false;  ///< the comparison was open when a window went
    };
    void connectList();
    void fillComparison();

    Document& m_document;
    Computation& m_computation;
    RunHistory& m_history;
    widgets::ScenarioList& m_scenarios;
    widgets::RunList& m_runs;
    QWidget& m_window;
    Kept& m_kept;
    QPointer<QDialog> m_dialog;
    widgets::ScenarioComparison* m_comparison = nullptr;
};

}  // namespace rubble
