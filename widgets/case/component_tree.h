#pragma once

#include <QColor>
#include <QWidget>
#include <set>
#include <string>
#include <vector>

#include "core/scenario/parameters.h"

class QLabel;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;
class QVBoxLayout;

namespace rubble::widgets {

class ParameterEditor;

/// All components with what is seen of them and what they are: visibility, colour, how many of their elements are alive and dead at
/// the time shown, and for the chosen one material and flags.
class ComponentTree : public QWidget {
    Q_OBJECT

public:
    struct Row {
        std::string name;
        std::string kind;      ///< "solid", "shell", "beam" or "mixed": components are grouped by it
        std::string material;  ///< as it is, guessed or set
        QColor colour;
        bool ownColour = false;  ///< the user chose it
        bool fits = true;        ///< a guessed material has the density of the component
    };
    struct Count {
        std::size_t alive = 0;
        std::size_t dead = 0;

        friend bool operator==(const Count&, const Count&) = default;
    };

    explicit ComponentTree(QWidget* parent = nullptr);

    void setRows(const std::vector<Row>& rows);
    /// By row.
    void setCounts(const std::vector<Count>& counts);
    void setHidden(const std::vector<std::string>& names);
    void setScenario(const Scenario& scenario);
    void setEditable(bool editable);
    /// The components that the rows chosen stand for.
    std::vector<std::string> chosen() const;
    QTreeWidget& tree() { return *m_tree; }

signals:
    /// Those that the user wants hidden from now on.
    void hiddenChanged(const std::vector<std::string>& names);
    void isolateRequested(const std::vector<std::string>& names);
    void showAllRequested();
    void selectRequested(const std::vector<std::string>& names);
    /// An invalid colour: the component's own again.
    void colourChosen(const QString& name, const QColor& colour);
    void edited(const QString& key, const rubble::ParameterValue& value);

private:
    enum Column { Name, Alive, Dead, ColumnCount };

    void build();
    void ticked(QTreeWidgetItem* item);
    void chooseColour();
    void showEditors();
    QTreeWidgetItem* itemOf(std::size_t row) const { return m_items[row]; }

    QTreeWidget* m_tree;
    QLabel* m_hint;
    QVBoxLayout* m_below;
    QToolButton* m_isolate;
    QToolButton* m_all;
    QToolButton* m_select;
    QToolButton* m_colour;
    QWidget* m_group = nullptr;
    std::vector<ParameterEditor*> m_editors;
    std::vector<Row> m_rows;
    std::vector<Count> m_counts;
    std::vector<QTreeWidgetItem*> m_items;  ///< by row
    std::set<std::string> m_hidden;
    Scenario m_scenario;
    bool m_editable = true;
    bool m_filling = false;
};

}  // namespace rubble::widgets
