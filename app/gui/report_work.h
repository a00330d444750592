#pragma once

#include <QObject>
#include <functional>

#include "widgets/render/scene_data.h"

class QWidget;

namespace rubble {

class Computation;
class Document;
class PanelDeck;

/// Makes reports of the run that is shown, in the background, from what the panel asks for.
class ReportWork : public QObject {
    Q_OBJECT

public:
    /// @param scene  what the views show
    ReportWork(Document& document, Computation& computation, PanelDeck& deck, std::function<render::SceneData()> scene,
               QWidget& window);

    /// Whether and why not a report can be made now.
    void refresh();
    /// Asks for a folder.
    void write();
    void writeTo(const QString& folder);
    bool writing() const { return m_writing; }

signals:
    void told(const QString& what);

private:
    QString whyNot() const;

    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    std::function<render::SceneData()> m_scene;
    QWidget& m_window;
    bool m_writing = false;
};

}  // namespace rubble
