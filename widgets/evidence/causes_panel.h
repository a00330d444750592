#pragma once

#include <QStringList>
#include <vector>

#include "core/evidence/ensembles/cause_comparison.h"
#include "widgets/basics/panel.h"

class QCheckBox;
class QListWidget;
class QPushButton;

namespace rubble::widgets {

class StudyStart;

/// Which supposed causes are held against which evidence, and how far that is.
class CausesPanel : public Panel {
    Q_OBJECT

public:
    explicit CausesPanel(QWidget* parent = nullptr);

    /// A cause or a piece of evidence in its list.
    struct Entry {
        QString name;
        QString tip;  ///< where it lies, or why it cannot be used
        bool used = true;
        bool usable = true;
        bool removable = false;
    };
    struct Content {
        std::vector<Entry> causes;
        std::vector<Entry> evidence;
        bool available = false;  ///< a case is open
        bool ready = false;
        bool running = false;
        QString why;      ///< it cannot be compared, or what happens meanwhile
        QString members;  ///< how many members each cause gets, and of what
        Findings findings;
    };
    void setContent(const Content& content);
    /// Whether each member in turn is to take the place of what was observed.
    void setBlind(bool blind);
    /// @param secondsLeft  NaN: not known yet
    void setProgress(const QString& what, double fraction, double secondsLeft);

signals:
    void addCausesRequested();
    void causeUsed(int cause, bool used);
    void causeRemoved(int cause);
    void addFootprintRequested();
    void addHeightsRequested();
    void addSurfaceRequested();
    /// A time at which debris reached a place was told.
    void timeTold(const rubble::TimeEvidence& time);
    void evidenceUsed(int evidence, bool used);
    void evidenceRemoved(int evidence);
    void blindChosen(bool blind);
    void compareRequested();
    void cancelRequested();

private:
    void buildCauses();
    void buildEvidence();
    void askForTime();
    void fill(QListWidget& list, const std::vector<Entry>& entries, const QString& none);
    void showRemovable();

    Content m_content;
    bool m_filling = false;
    StudyStart* m_start;
    QListWidget* m_causes;
    QPushButton* m_addCauses;
    QPushButton* m_removeCause;
    QLabel* m_members = nullptr;
    QListWidget* m_evidence;
    QPushButton* m_addEvidence;
    QPushButton* m_removeEvidence;
    QCheckBox* m_blind;
    FindingList* m_findings;
};

}  // namespace rubble::widgets
