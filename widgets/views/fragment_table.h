#pragma once

#include <QTableView>
#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "widgets/render/basics/fragment_filter.h"
#include "widgets/views/fragment_model.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace rubble::widgets {

class NumberField;

/// All fragments in a table, with bounds that leave fragments out of table and views. What is chosen in the table is told as
/// elements, and what is selected elsewhere is chosen in it.
class FragmentTable : public QWidget {
    Q_OBJECT

public:
    explicit FragmentTable(QWidget* parent = nullptr);

    /// Other fragments, components or clusters; without fragments it says what is to be done.
    void setData(const render::SceneData& scene);
    /// As FragmentModel::setSpeeds().
    void setSpeeds(std::vector<double> speeds);
    /// Bounds as a view has them.
    void setFilter(const render::FragmentFilter& filter);
    const render::FragmentFilter& filter() const { return m_filter; }
    /// Chooses the rows of these elements and brings the first of them into sight.
    void setSelection(const std::vector<ElementIndex>& elements);
    const FragmentModel& model() const { return *m_model; }
    QTableView& rows() { return *m_rows; }
    /// How many fragments of how many meet the bounds, in words.
    QString countWords() const;
    QSize sizeHint() const override { return {620, 230}; }

signals:
    /// Rows were chosen by hand.
    void selectionRequested(const std::vector<rubble::ElementIndex>& elements);
    /// A row was double-clicked, or Enter pressed on it.
    void birthRequested();
    void filterEdited(const rubble::render::FragmentFilter& filter);

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* buildBounds();
    void addBounds(QGridLayout& grid, int row, const QString& name, const char* unit, const QString& tip,
                   render::FilterRange render::FragmentFilter::* range);
    void edit(const render::FragmentFilter& filter);
    void sift();
    void tellSelection();
    void showSelection(bool inSight);
    void showCount();

    struct Bounds {
        render::FilterRange render::FragmentFilter::* range;
        NumberField* low;
        NumberField* high;
    };
    FragmentModel* m_model;
    QTableView* m_rows;
    std::vector<Bounds> m_bounds;
    QComboBox* m_component;
    QPushButton* m_clear;
    QLabel* m_count;
    render::SceneData m_data;
    render::FragmentFilter m_filter;
    std::vector<ElementIndex> m_selection;
    bool m_showing = false;
};

}  // namespace rubble::widgets
