#pragma once

#include <memory>

#include "core/fe/fe_result.h"
#include "core/fragments/fragment_set.h"
#include "widgets/basics/panel.h"

class QLabel;

namespace rubble::widgets {

/// What became debris, and when: counts, mass, births, the policy for revived elements, findings.
class FragmentsPanel : public Panel {
    Q_OBJECT

public:
    explicit FragmentsPanel(QWidget* parent = nullptr);
    /// @param fragments  null while there are none
    void setContent(const std::shared_ptr<const FragmentSet>& fragments, const FeResult* fe);

private:
    QLabel* m_count;
    QLabel* m_mass;
    QLabel* m_births;
    QLabel* m_first;
    QLabel* m_last;
    QLabel* m_largestBirth;
    QLabel* m_smallest;
    QLabel* m_fastest;
    QLabel* m_note;
    FindingList* m_findings;
};

}  // namespace rubble::widgets
