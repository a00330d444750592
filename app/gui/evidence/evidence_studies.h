#pragma once

#include <QObject>

#include "app/gui/studies/study_work.h"

class QWidget;

namespace rubble {

class Actions;
class CausesDisplay;
class Computation;
class Document;
class Session;
class EnsembleDisplay;
class PanelDeck;
namespace widgets {
class CausesPage;
class EnsemblePage;
}  // namespace widgets

/// The studies of what is not known: the ensemble of the case, and which of several causes explains what was found. One worker does
/// both, one after the other.
class EvidenceStudies : public QObject {
    Q_OBJECT

public:
    EvidenceStudies(Session& session, PanelDeck& deck, Actions& actions, QObject* parent = nullptr);

    StudyWork& work() { return m_work; }
    EnsembleDisplay& ensemble() { return *m_ensemble; }
    CausesDisplay& causes() { return *m_causes; }
    widgets::EnsemblePage& ensemblePage() { return *m_ensemblePage; }
    widgets::CausesPage& causesPage() { return *m_causesPage; }
    /// Other work runs beside which nothing can be simulated; empty: none does.
    void setBusy(const QString& why);
    void refresh();

signals:
    /// A study began or ended.
    void changed();
    void saveChartRequested();

private:
    void connectActions(PanelDeck& deck, Actions& actions);

    StudyWork& m_work;
    widgets::EnsemblePage* m_ensemblePage;  // the window owns the pages
    widgets::CausesPage* m_causesPage;
    EnsembleDisplay* m_ensemble;
    CausesDisplay* m_causes;
};

}  // namespace rubble
