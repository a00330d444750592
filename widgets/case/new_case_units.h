#pragma once

#include <vector>

#include "core/fe/unit_evidence.h"
#include "widgets/basics/panel.h"

class QPushButton;
class QTableWidget;

namespace rubble::widgets {

/// First step of a new case: what the file holds, in which units it counts and which axis points up, with what speaks for them.
class NewCaseUnits : public Panel {
    Q_OBJECT

public:
    /// What a file tells about its units and axes, as it was last read.
    struct Evidence {
        std::vector<UnitFit> fits;  ///< the best first
        Proposal units;
        Proposal upAxis;
    };

    explicit NewCaseUnits(QWidget* parent = nullptr);

    /// @param fe    null until a file is read; @param mass  kg, of all elements, NaN while it is not known
    void setContent(const FeResult* fe, double mass);
    void setEvidence(const Evidence& evidence);
    /// Id of the system that the file was read in; empty: none, or not known.
    const std::string& taken() const { return m_taken; }
    /// Ids of the systems that fit about as well as the one that was taken; empty: it fits best.
    QString rivals() const;

private:
    void buildTable();
    void showFits();
    void fitRows();
    void showProposals();
    void take(const char* key, const std::string& choice);

    QLabel* m_format;
    QLabel* m_elements;
    QLabel* m_states;
    QLabel* m_span;
    QLabel* m_size;
    QLabel* m_mass;
    Notice* m_unitsProposal;
    Notice* m_axisProposal;
    QPushButton* m_takeUnits;
    QPushButton* m_takeAxis;
    QTableWidget* m_fits;
    FindingList* m_findings;
    Evidence m_evidence;
    std::string m_taken;  ///< id of the system that the file was read in
    std::string m_axis;   ///< that was taken to point up
};

}  // namespace rubble::widgets
