#pragma once

#include <QObject>
#include <optional>

#include "app/gui/session/worker.h"
#include "widgets/evidence/report_panel.h"

class QWidget;

namespace rubble {

class Actions;
class Computation;
class Document;
class PanelDeck;
class SceneDisplay;
class Session;

/// Reports, whoever shows how they are made.
class ReportKept : public QObject {
    Q_OBJECT

public:
    bool writing = false;
    QString written;  ///< folder of the last one; empty: there is none
    std::optional<Failure> failure;
    std::optional<widgets::ReportWishes> wishes;  ///< what the panel was set to when a window went

signals:
    void changed();
};

/// Makes reports of the run that is shown, in the background, from what the panel asks for.
class ReportWork : public QObject {
    Q_OBJECT

public:
    ReportWork(Session& session, PanelDeck& deck, SceneDisplay& scene, Actions& actions, QWidget& window);
    ~ReportWork() override;

    /// Whether and why not a report can be made now.
    void refresh();
    /// Asks for a folder.
    void write();
    void writeTo(const QString& folder);
    bool writing() const { return m_kept.writing; }

private:
    void showOutcome();
    QString whyNot() const;

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    SceneDisplay& m_scene;
    QWidget& m_window;
    ReportKept& m_kept;
};

}  // namespace rubble
