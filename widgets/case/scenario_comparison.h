#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/pipeline/run_entry.h"
#include "core/scenario/scenario.h"

class QComboBox;
class QLabel;
class QTableWidget;

namespace rubble::widgets {

/// A scenario with the newest complete run that is known of it.
struct ScenarioSide {
    QString id;
    QString name;
    QString note;
    Scenario scenario;
    std::optional<RunEntry> run;
    bool runStale = false;  ///< made with other settings, inputs or another build than there are now
};

/// Two scenarios side by side: the settings in which they differ, and what their runs came to.
class ScenarioComparison : public QWidget {
    Q_OBJECT

public:
    explicit ScenarioComparison(QWidget* parent = nullptr);

    /// What was chosen stays chosen as long as it is there.
    void setContent(std::vector<ScenarioSide> sides);
    void choose(const QString& left, const QString& right);
    QTableWidget& settings() { return *m_settings; }
    QTableWidget& results() { return *m_results; }

private:
    void show();
    void showSettings(const ScenarioSide& left, const ScenarioSide& right);
    void showResults(const ScenarioSide& left, const ScenarioSide& right);
    const ScenarioSide* sideOf(const QComboBox& choice) const;

    std::vector<ScenarioSide> m_sides;
    QComboBox* m_left;
    QComboBox* m_right;
    QLabel* m_notes;
    QLabel* m_same;
    QTableWidget* m_settings;
    QLabel* m_runs;
    QTableWidget* m_results;
};

}  // namespace rubble::widgets
