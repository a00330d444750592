#pragma once

#include <QAbstractTableModel>
#include <string>
#include <vector>

#include "core/base/ids.h"
#include "widgets/render/basics/scene_data.h"

namespace rubble::widgets {

/// All fragments of a run as a table, one row each; sorted and filtered here, so that 50,000 rows stay quick.
class FragmentModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Number, Element, Component, Birth, Mass, Size, Speed, Cluster, ColumnCount };

    explicit FragmentModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

    /// Other fragments; without any the table is empty.
    void setData(const render::SceneData& data);
    /// @param speeds  m/s [fragments]; NaN: not carried now
    void setSpeeds(std::vector<double> speeds);
    /// Which fragments have a row, 1 for those [fragments]; empty: all.
    void setShown(std::vector<std::uint8_t> shown);
    const std::vector<double>& speeds() const { return m_speeds; }
    /// All fragments, with or without a row.
    std::size_t fragmentCount() const;

    FragmentId fragmentAt(int row) const { return m_order[static_cast<std::size_t>(row)]; }
    ElementIndex elementAt(int row) const;
    /// The row of a fragment; -1: it has none.
    int rowOf(FragmentId fragment) const { return m_rowOf[at(fragment)]; }
    /// The rows of elements, ascending; those of elements without a row are left out.
    std::vector<int> rowsOf(const std::vector<ElementIndex>& elements) const;
    Column sortedBy() const { return m_sortedBy; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;

private:
    QString textOf(FragmentId fragment, Column column) const;
    double figureOf(FragmentId fragment, Column column) const;
    void arrange();

    render::SceneData m_data;
    std::vector<double> m_speeds;
    std::vector<std::uint8_t> m_shown;
    std::vector<FragmentId> m_order;  ///< by row
    std::vector<int> m_rowOf;         ///< by fragment
    Column m_sortedBy = Number;
    Qt::SortOrder m_sortOrder = Qt::AscendingOrder;
};

}  // namespace rubble::widgets
