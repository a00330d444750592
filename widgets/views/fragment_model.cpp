#include "widgets/views/fragment_model.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "widgets/basics/wording.h"
#include "widgets/figures/shown_units.h"
#include "widgets/render/basics/fragment_filter.h"

namespace rubble::widgets {

namespace {

QString withUnit(const QString& name, const char* unit) {
    return QStringLiteral("%1, %2").arg(name, figures::shownUnit(unit).name);
}

}  // namespace

std::size_t FragmentModel::fragmentCount() const {
    return m_data.fragments != nullptr ? m_data.fragments->size() : 0;
}

ElementIndex FragmentModel::elementAt(int row) const {
    return m_data.fragments->list[at(fragmentAt(row))].element;
}

void FragmentModel::setData(const render::SceneData& data) {
    const bool same =
        data.fragments == m_data.fragments && data.components == m_data.components && data.clustering == m_data.clustering;
    m_data = data;
    if (!same) {
        m_speeds.assign(fragmentCount(), std::numeric_limits<double>::quiet_NaN());
        m_shown.clear();
        arrange();
    }
}

void FragmentModel::setSpeeds(std::vector<double> speeds) {
    if (speeds.size() != fragmentCount()) {
        return;
    }
    m_speeds = std::move(speeds);
    if (m_sortedBy == Speed) {
        arrange();
    } else if (!m_order.empty()) {
        emit dataChanged(index(0, Speed), index(rowCount() - 1, Speed), {Qt::DisplayRole});
    }
}

void FragmentModel::setShown(std::vector<std::uint8_t> shown) {
    if (shown != m_shown) {
        m_shown = std::move(shown);
        arrange();
    }
}

void FragmentModel::sort(int column, Qt::SortOrder order) {
    if (column >= 0 && column < ColumnCount) {
        m_sortedBy = static_cast<Column>(column);
        m_sortOrder = order;
        arrange();
    }
}

/// Rows anew: those that are shown, in their order. Equal ones stand by number.
void FragmentModel::arrange() {
    beginResetModel();
    m_order.clear();
    for (std::size_t f = 0; f < fragmentCount(); ++f) {
        if (m_shown.empty() || m_shown[f] != 0) {
            m_order.push_back(idAt<FragmentId>(f));
        }
    }
    std::vector<double> keys(fragmentCount());
    for (std::size_t f = 0; f < keys.size(); ++f) {
        keys[f] = figureOf(idAt<FragmentId>(f), m_sortedBy);
    }
    const bool descending = m_sortOrder == Qt::DescendingOrder;
    std::stable_sort(m_order.begin(), m_order.end(), [&](FragmentId a, FragmentId b) {
        const double x = keys[at(a)];
        const double y = keys[at(b)];
        if (std::isnan(x) || std::isnan(y)) {
            return std::isnan(y) && !std::isnan(x);  // what is not known stands last either way
        }
        return descending ? x > y : x < y;
    });
    m_rowOf.assign(fragmentCount(), -1);
    for (std::size_t row = 0; row < m_order.size(); ++row) {
        m_rowOf[at(m_order[row])] = static_cast<int>(row);
    }
    endResetModel();
}

std::vector<int> FragmentModel::rowsOf(const std::vector<ElementIndex>& elements) const {
    std::vector<int> rows;
    if (elements.empty() || m_data.fe == nullptr) {
        return rows;
    }
    std::vector<std::uint8_t> wanted(m_data.fe->mesh().elementCount(), 0);
    for (const ElementIndex element : elements) {
        if (at(element) < wanted.size()) {
            wanted[at(element)] = 1;
        }
    }
    for (int row = 0; row < rowCount(); ++row) {
        if (wanted[at(elementAt(row))] != 0) {
            rows.push_back(row);
        }
    }
    return rows;
}

int FragmentModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_order.size());
}

int FragmentModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

double FragmentModel::figureOf(FragmentId id, Column column) const {
    const Fragment& fragment = m_data.fragments->list[at(id)];
    switch (column) {
        case Element:
            return static_cast<double>(m_data.fe->mesh().elementIds[at(fragment.element)]);
        case Component:
            return static_cast<double>(at(fragment.component));
        case Birth:
            return fragment.birthTime;
        case Mass:
            return fragment.mass;
        case Size:
            return render::longestSide(fragment);
        case Speed:
            return m_speeds[at(id)];
        case Cluster:
            return m_data.clustering != nullptr && at(id) < m_data.clustering->of.size()
                       ? static_cast<double>(at(m_data.clustering->of[at(id)]))
                       : std::numeric_limits<double>::quiet_NaN();
        case Number:
        case ColumnCount:
            break;
    }
    return static_cast<double>(at(id));
}

QString FragmentModel::textOf(FragmentId id, Column column) const {
    const double figure = figureOf(id, column);
    switch (column) {
        case Component: {
            const std::size_t component = at(m_data.fragments->list[at(id)].component);
            return m_data.components != nullptr && component < m_data.components->list.size()
                       ? QString::fromStdString(m_data.components->list[component].name)
                       : QString();
        }
        case Birth:
            return QLocale().toString(figure * figures::shownUnit("s").perSi, 'f', 2);
        case Mass:
            return shownIn(figure, "kg");
        case Size:
            return shownIn(figure, "m");
        case Speed:
            return shownIn(figure, "m/s");
        case Number:
        case Element:
        case Cluster:
        case ColumnCount:
            break;
    }
    return std::isnan(figure) ? QStringLiteral("–") : shownCount(static_cast<std::int64_t>(figure));
}

QVariant FragmentModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const auto column = static_cast<Column>(index.column());
    if (role == Qt::DisplayRole) {
        return textOf(fragmentAt(index.row()), column);
    }
    if (role == Qt::TextAlignmentRole) {
        return static_cast<int>((column == Component ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    }
    return {};
}

QVariant FragmentModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return static_cast<int>((section == Component ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    }
    if (role == Qt::ToolTipRole) {
        const std::array tips = {
            tr("Number of the fragment"),
            tr("Number of its element in the FE result"),
            tr("Component that its element belongs to"),
            tr("When it is shown and reported as a fragment"),
            tr("Volume at rest times the density of its component"),
            tr("Longest side of the box around it"),
            tr("Of the body that carries it, at the time shown; a dash: none does then. Without a run: as it is born"),
            tr("Number of the cluster that it moves with")};
        return tips[static_cast<std::size_t>(section)];
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (static_cast<Column>(section)) {
        case Number:
            return tr("fragment");
        case Element:
            return tr("element");
        case Component:
            return tr("component");
        case Birth:
            return withUnit(tr("born"), "s");
        case Mass:
            return withUnit(tr("mass"), "kg");
        case Size:
            return withUnit(tr("longest side"), "m");
        case Speed:
            return withUnit(tr("speed"), "m/s");
        case Cluster:
        case ColumnCount:
            break;
    }
    return tr("cluster");
}

}  // namespace rubble::widgets
