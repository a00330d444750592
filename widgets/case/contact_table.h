#pragma once

#include <QWidget>
#include <optional>
#include <set>

#include "core/scenario/parameters.h"

class QCheckBox;
class QLabel;
class QTableWidget;

namespace rubble::widgets {

/// Friction and restitution of every pair of materials: an editable table with the source of each default below it. A changed value
/// carries a mark that gives the default back; Delete and an emptied cell do the same. Emits edited() and never changes a value by
/// itself.
class ContactTable : public QWidget {
    Q_OBJECT

public:
    enum Column { Pair, Friction, Restitution, Source, ColumnCount };
    explicit ContactTable(QWidget* parent = nullptr);

    void setScenario(const Scenario& scenario);
    /// Materials of the scene; pairs of others are shown on request only. Empty: all are shown.
    void setMaterials(const std::set<Material>& materials);
    void setEditable(bool editable);
    /// Gives a cell its default back.
    void reset(int row, int column);
    QTableWidget* table() const { return m_table; }

signals:
    /// The user changed a value of a pair.
    void edited(const QString& key, const rubble::ParameterValue& value);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fill();
    void fillRow(int row, MaterialPair pair);
    QString cite(const QString& source);
    void typed(int row, int column);
    bool changed(MaterialPair pair, int column) const;

    QTableWidget* m_table;
    QCheckBox* m_all;
    QLabel* m_complaint;
    QLabel* m_sources;
    PairTable m_pairs;                    // as they were set
    PairTable m_acting;                   // as a run takes them
    std::optional<double> m_friction;     // holds for every pair where set
    std::optional<double> m_restitution;  // the same
    std::set<Material> m_materials;
    std::vector<MaterialPair> m_shown;
    QStringList m_cited;
    bool m_filling = false;
};

}  // namespace rubble::widgets
