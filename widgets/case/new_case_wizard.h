#pragma once

#include <QDialog>
#include <array>

#include "widgets/case/new_case_components.h"
#include "widgets/case/new_case_deaths.h"
#include "widgets/case/new_case_ground.h"
#include "widgets/case/new_case_summary.h"
#include "widgets/case/new_case_units.h"

class QButtonGroup;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace rubble::widgets {

/// Makes a case from an FE result in five steps, beside a preview. Every step can be left in any direction; nothing is kept before
/// the case is made. Enter never goes on by itself: it settles what is being typed.
/// Esc leaves a field first; who then leaves the wizard by hand is asked where something was chosen.
class NewCaseWizard : public QDialog {
    Q_OBJECT

public:
    enum Step { Units, Ground, Components, Deaths, Summary, StepCount };

    /// @param preview  shows the model, beside the steps
    NewCaseWizard(const QString& file, QWidget* preview, QWidget* parent = nullptr);

    NewCaseUnits& units() { return *m_units; }
    NewCaseGround& ground() { return *m_ground; }
    NewCaseComponents& components() { return *m_components; }
    NewCaseDeaths& deaths() { return *m_deaths; }
    NewCaseSummary& summary() { return *m_summary; }
    std::array<Panel*, StepCount> panels() const;

    Step step() const;
    void go(Step step);
    /// What runs, and how far it is; an empty text: nothing.
    void setProgress(const QString& what, double fraction);
    /// Whether a result is there to make a case from.
    void setReady(bool ready);
    /// Components whose density no material has, in words; empty: none. Who goes on from the units, or makes the case, is asked
    /// first.
    void setOddDensities(const QString& components);
    /// Names of the edits that would be taken back or made again; empty: none.
    void setUndo(const QString& undo, const QString& redo);

signals:
    void stepChanged(int step);
    void createRequested();
    void undoRequested();
    void redoRequested();
    /// Somebody goes on with units that the file does not decide: they are chosen now.
    void unitsAccepted();
    /// What is being read shall stop.
    void stopRequested();
    /// Another language is spoken: what was put together from words of core is to be said anew.
    void languageChanged();

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* buildSteps();
    QWidget* buildButtons();
    void showState();
    /// Whether to leave the units as they are; asks where nobody chose among those that fit, and where a density is that of no
    /// material.
    bool mayGoOn();
    bool acceptsUnits();
    /// Asks; goes back to the units unless somebody goes on.
    bool goesOn(const QString& title, const QString& what, const QString& why, const QString& onward);
    /// Whether what was chosen may be given up; asks where something was.
    bool mayLeave();
    /// Gives the new case up by hand.
    void leaveByHand();
    /// As go(), by hand.
    void goByHand(int step);

    NewCaseUnits* m_units;
    NewCaseGround* m_ground;
    NewCaseComponents* m_components;
    NewCaseDeaths* m_deaths;
    NewCaseSummary* m_summary;
    QStackedWidget* m_stack;
    QButtonGroup* m_steps;
    QPushButton* m_undo;
    QPushButton* m_redo;
    QPushButton* m_cancel;
    QPushButton* m_back;
    QPushButton* m_next;
    QPushButton* m_create;
    QLabel* m_activity;
    QProgressBar* m_progress;
    QPushButton* m_stop;
    QString m_oddDensities;
    QString m_acceptedDensities;  ///< that were gone on with all the same
    bool m_unitsChosen = false;   ///< by hand
    bool m_ready = false;
};

}  // namespace rubble::widgets
