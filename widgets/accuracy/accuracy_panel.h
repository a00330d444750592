#pragma once

#include "core/analysis/accuracy/accuracy_settings.h"
#include "widgets/basics/panel.h"

class QCheckBox;
class QLineEdit;
class QSpinBox;

namespace rubble::widgets {

class PlaceChoice;
class StudyStart;

/// Which settings to compare, and how far the comparison is.
class AccuracyPanel : public Panel {
    Q_OBJECT

public:
    explicit AccuracyPanel(QWidget* parent = nullptr);

    /// What the user asks for.
    struct Request {
        std::vector<std::string> multiples;  ///< of the mean distance, "auto" among them; empty: the grid as set
        std::vector<VariedParameter> varied;
        int repeats = 2;                                ///< of the reference
        int settingRepeats = 0;                         ///< of every setting
        std::vector<double> tolerances{0.1, 0.2, 0.3};  ///< m, of the accuracy rate; ascending
        bool liveFps = true;
        bool retimed = false;  ///< times that are kept do not count
        bool onCluster = false;
        std::vector<std::string> sbatchOptions;
    };
    Request request() const;
    /// Shows what was asked for earlier; only other tolerances are announced.
    void setRequest(const Request& request);
    PlaceChoice& place() { return *m_place; }
    /// @param why  it cannot be started, or what happens meanwhile
    void setReady(bool ready, bool running, const QString& why);
    /// @param secondsLeft  NaN: not known yet
    void setProgress(const QString& what, double fraction, double secondsLeft);
    void setFindings(const Findings& findings);
    /// Where finished worlds are kept.
    void setFolder(const QString& folder);

    /// As typed, if they can be read.
    const std::vector<double>& tolerances() const { return m_tolerances; }

signals:
    /// The user settled on other tolerances [m].
    void tolerancesChanged(const std::vector<double>& tolerances);
    void calibrationRequested();
    void compareRequested();
    void cancelRequested();

private:
    void buildChoices();
    void buildMachine();
    void readTolerances();

    QLineEdit* m_multiples;
    QLineEdit* m_varied;
    QLineEdit* m_toleranceField;
    QLabel* m_toleranceWhy;
    std::vector<double> m_tolerances{0.1, 0.2, 0.3};
    QSpinBox* m_repeats;
    QSpinBox* m_settingRepeats;
    QCheckBox* m_liveFps;
    QCheckBox* m_retimed;
    PlaceChoice* m_place;
    StudyStart* m_start;
    QLabel* m_folder = nullptr;
    FindingList* m_findings;
};

}  // namespace rubble::widgets
