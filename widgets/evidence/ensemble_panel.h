#pragma once

#include <memory>

#include "core/evidence/ensembles/ensemble.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/varied_table.h"

class QCheckBox;
class QSpinBox;

namespace rubble::widgets {

class NumberField;
class PlaceChoice;
class StudyStart;

/// What an ensemble varies, how many members it has, and how far its simulation is. Shows what it is given; an edit of what the
/// case keeps leaves as a whole.
class EnsemblePanel : public Panel {
    Q_OBJECT

public:
    explicit EnsemblePanel(QWidget* parent = nullptr);

    struct Content {
        EnsembleSettings settings{usualVariations()};
        std::vector<VariedTable::Choice> scenarios;
        bool available = false;  ///< a case is open: its settings can be edited
        bool ready = false;      ///< members can be simulated
        bool running = false;
        QString why;               ///< they cannot be, or what happens meanwhile
        double runSeconds = -1.0;  ///< that a run took; below zero: not known
        Findings findings;
    };
    void setContent(const Content& content);
    /// How debris is laid on the ground.
    SurfaceSettings surface() const;
    DebrisInstant instant() const;
    void setSurface(const SurfaceSettings& surface, DebrisInstant instant);
    PlaceChoice& place() { return *m_place; }
    /// @param secondsLeft  NaN: not known yet
    void setProgress(const QString& what, double fraction, double secondsLeft);
    /// Where finished members are kept.
    void setFolder(const QString& folder);

signals:
    /// @param what  names the edit for undo
    void settingsEdited(const rubble::EnsembleSettings& settings, const rubble::widgets::Wording& what);
    /// Cells, instant or what counts as debris have changed.
    void surfaceChanged();
    void simulateRequested();
    void cancelRequested();

private:
    void buildMembers();
    void buildDebris();
    void showCost();

    Content m_content;
    PlaceChoice* m_place;
    StudyStart* m_start;
    QLabel* m_cost = nullptr;
    VariedTable* m_varied;
    QSpinBox* m_members;
    NumberField* m_seed;
    NumberField* m_cell;
    QCheckBox* m_withFallen;
    QCheckBox* m_atFeEnd;
    QLabel* m_folder = nullptr;
    FindingList* m_findings;
};

}  // namespace rubble::widgets
