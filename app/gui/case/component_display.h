#pragma once

#include <QObject>

#include "core/fe/components.h"

namespace rubble {

class Computation;
class Document;
namespace widgets {
class ComponentTree;
class PlaybackClock;
class ViewWidget;
}  // namespace widgets

/// Keeps the component tree in step with document, computation and clock, and brings what the user does in it to the views and, as
/// undoable edits, to the document.
class ComponentDisplay : public QObject {
    Q_OBJECT

public:
    ComponentDisplay(Document& document, Computation& computation, widgets::PlaybackClock& clock, widgets::ViewWidget& views,
                     widgets::ComponentTree& tree, QObject* parent = nullptr);

    /// Results, settings or colours have changed.
    void refresh();
    /// Hides all components but these.
    void isolate(const std::vector<std::string>& names);
    void showAll();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showCounts();
    void select(const std::vector<std::string>& names);
    void setHidden(const std::vector<std::string>& names);
    void setColour(const QString& name, const QColor& colour);

    Document& m_document;
    Computation& m_computation;
    widgets::PlaybackClock& m_clock;
    widgets::ViewWidget& m_views;
    widgets::ComponentTree& m_tree;
};

}  // namespace rubble
