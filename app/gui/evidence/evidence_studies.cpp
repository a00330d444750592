#include "app/gui/evidence/evidence_studies.h"

#include "app/gui/evidence/causes_display.h"
#include "app/gui/evidence/ensemble_display.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "app/gui/stage/panel_deck.h"
#include "widgets/evidence/causes_page.h"
#include "widgets/evidence/causes_panel.h"
#include "widgets/evidence/ensemble_page.h"
#include "widgets/evidence/ensemble_panel.h"

namespace rubble {

EvidenceStudies::EvidenceStudies(Session& session, PanelDeck& deck, Actions& actions, QObject* parent)
    : QObject(parent),
      m_work(session.part<StudyWork>()),
      m_ensemblePage(new widgets::EnsemblePage),
      m_causesPage(new widgets::CausesPage),
      m_ensemble(new EnsembleDisplay(session, deck.ensemble(), *m_ensemblePage, this)),
      m_causes(new CausesDisplay(session, *m_ensemble, deck.causes(), *m_causesPage, this)) {
    connect(&m_work, &StudyWork::begun, this, [this] {
        refresh();
        emit changed();
    });
    connect(&m_work, &StudyWork::ended, this, [this] {
        refresh();
        emit changed();
    });
    connect(m_causes, &CausesDisplay::saveChartRequested, this, &EvidenceStudies::saveChartRequested);
    connect(&deck.ensemble(), &widgets::EnsemblePanel::surfaceChanged, m_causes, &CausesDisplay::refresh);
    connectActions(deck, actions);
    m_work.tellProgress();
}

void EvidenceStudies::connectActions(PanelDeck& deck, Actions& actions) {
    const auto on = [&](ActionId id, auto slot) { connect(&actions[id], &QAction::triggered, this, slot); };
    on(ActionId::ShowEnsemble, [&deck] { deck.chooseEvidence(PanelDeck::Ensemble); });
    on(ActionId::ShowCauses, [&deck] { deck.chooseEvidence(PanelDeck::Causes); });
    on(ActionId::SimulateEnsemble, [this, &deck] {
        deck.chooseEvidence(PanelDeck::Ensemble);
        m_ensemble->simulate();
    });
    on(ActionId::CompareCauses, [this, &deck] {
        deck.chooseEvidence(PanelDeck::Causes);
        m_causes->compare();
    });
}

void EvidenceStudies::setBusy(const QString& why) {
    m_ensemble->setBusy(why);
    m_causes->setBusy(why);
}

void EvidenceStudies::refresh() {
    m_ensemble->refresh();
    m_causes->refresh();
}

}  // namespace rubble
