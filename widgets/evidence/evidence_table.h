#pragma once

#include <QTableWidget>
#include <vector>

#include "core/evidence/evidence_list.h"

namespace rubble::widgets {

/// "photograph", "point cloud", in the language that is spoken.
QString evidenceFormText(EvidenceForm form);

/// All evidence of a case, one row each: what it is, what it is held to show, how well its place is known, and its score. Of
/// measured points a person chooses in their row what they are held to show.
class EvidenceTable : public QTableWidget {
    Q_OBJECT

public:
    explicit EvidenceTable(QWidget* parent = nullptr);

    void setRows(const std::vector<EvidenceRow>& rows);

signals:
    /// A row was chosen by a person. @param id  of the input; empty: the control points
    void chosen(const QString& id);
    /// What measured points are held to say was chosen. @param id  of the input
    void held(const QString& id, rubble::PointsHeld as);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void fitRows();
    void offerHeld(int row);

    bool m_showing = false;
    std::vector<EvidenceRow> m_rows;
};

}  // namespace rubble::widgets
