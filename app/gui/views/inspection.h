#pragma once

#include <QObject>

#include "app/gui/stage/actions.h"

class QDockWidget;

namespace rubble {

class ComponentDisplay;
class DockArea;
class FragmentList;
class HistoryDisplay;
class Playback;
class SelectionDisplay;
class Session;
class ViewArea;
class ViewTools;
namespace widgets {
class ComponentTree;
class FragmentTable;
class HistoryPanel;
class Inspector;
class SelectForm;
}  // namespace widgets

/// What is done with the model in the views: the docks around them (components, Inspector, selecting, table and curves) and the
/// actions that select, hide, cut and measure.
class Inspection : public QObject {
    Q_OBJECT

public:
    Inspection(Session& session, Playback& playback, ViewArea& area, Actions& actions, QObject* parent = nullptr);
    ~Inspection() override;

    /// To be put into the window with the views as its central widget.
    DockArea& docks() { return *m_docks; }
    QDockWidget& dock(const char* name) const;
    widgets::ComponentTree& tree() { return *m_tree; }
    widgets::Inspector& inspector() { return *m_inspector; }
    widgets::SelectForm& form() { return *m_form; }
    SelectionDisplay& selection() { return *m_selection; }
    ComponentDisplay& components() { return *m_components; }
    widgets::FragmentTable& table() { return *m_table; }
    FragmentList& list() { return *m_list; }
    HistoryDisplay& history() { return *m_history; }
    ViewTools& tools() { return *m_tools; }
    /// Another result, run, scenario or view is shown.
    void refresh();

private:
    void connectActions();
    void selectionChanged(bool something);

    Actions& m_actions;
    ViewArea& m_area;
    DockArea* m_docks;
    widgets::ComponentTree* m_tree;
    widgets::Inspector* m_inspector;
    widgets::SelectForm* m_form;
    widgets::FragmentTable* m_table;
    widgets::HistoryPanel* m_curves;
    QDockWidget* m_treeDock;
    QDockWidget* m_formDock;
    QDockWidget* m_inspectorDock;
    QDockWidget* m_tableDock;
    QDockWidget* m_curvesDock;
    ComponentDisplay* m_components;
    SelectionDisplay* m_selection;
    FragmentList* m_list;
    HistoryDisplay* m_history;
    ViewTools* m_tools;
    bool m_something = false;
};

}  // namespace rubble
