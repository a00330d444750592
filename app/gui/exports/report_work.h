#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "app/gui/exports/run_orders.h"
#include "app/gui/session/worker.h"
#include "core/evidence/report_facts.h"
#include "io/run/run_file.h"
#include "widgets/evidence/report_panel.h"

class QWidget;

namespace rubble {

class Actions;
class CausesDisplay;
class Computation;
class Document;
class PanelDeck;
class SceneDisplay;
class Session;
struct MadeComparison;

/// Reports, whoever shows how they are made.
class ReportKept : public QObject {
    Q_OBJECT

public:
    bool writing = false;
    QString written;  ///< folder of the last one; empty: there is none
    std::optional<Failure> failure;
    std::optional<widgets::ReportWishes> wishes;      ///< what the panel was set to when a window went
    QString base;                                     ///< of the case whose words the panel holds
    QString notes;                                    ///< file that these words are kept in; empty: none
    std::map<QString, widgets::ReportWishes> others;  ///< of cases that were open before, by their base
    std::optional<ReportFacts> facts;                 ///< of the last check, while they hold
    std::shared_ptr<const io::RunReader> of;          ///< the run of that check

signals:
    void changed();
};

/// Makes reports of the run that is shown, in the background, from what the panel asks for, and tells what they would lack.
class ReportWork : public QObject {
    Q_OBJECT

public:
    ReportWork(Session& session, PanelDeck& deck, SceneDisplay& scene, Actions& actions, QWidget& window);
    /// Where comparisons come from.
    void setCauses(CausesDisplay& causes) { m_causes = &causes; }
    ~ReportWork() override;

    /// Whether and why not a report can be made now.
    void refresh();
    /// Asks for a folder.
    void write();
    void writeTo(const QString& folder);
    /// Collects what the report would say, for what it lacks; simulates and writes nothing.
    void check();
    bool writing() const { return m_kept.writing; }
    /// What the panel asks for, of a run that is yet to be named.
    ReportOrder wished() const;

private:
    /// Everything that is needed for the run that is shown, as it is now, but for the scene.
    ReportOrder orderNow() const;
    void start(std::function<void(const Execution&)> work, std::function<QString()> done);
    void showOutcome();
    /// Words about one collapse are not those about another.
    void changeCase();
    /// What was checked does not hold any more.
    void dropCheck();
    void showGaps();
    void chooseCauses();
    /// Beside the case, or in the state folder where nothing can be written there; empty: nothing is open.
    QString notesFile() const;
    void takeNotes();
    void keepNotes();
    /// The comparison of the page Causes; null: there is none that is of now.
    const MadeComparison* comparison() const;
    /// Why there is none for a report; empty: there is.
    QString whyNoComparison() const;
    QString whyNot() const;

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    SceneDisplay& m_scene;
    QWidget& m_window;
    ReportKept& m_kept;
    CausesDisplay* m_causes = nullptr;
    QTimer m_keeping;  // what was said is kept once its author pauses
};

}  // namespace rubble
