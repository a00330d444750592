#include "app/gui/evidence_studies.h"

#include "app/gui/causes_display.h"
#include "app/gui/ensemble_display.h"
#include "app/gui/panel_deck.h"
#include "widgets/causes_page.h"
#include "widgets/causes_panel.h"
#include "widgets/ensemble_page.h"
#include "widgets/ensemble_panel.h"

namespace rubble {

EvidenceStudies::EvidenceStudies(Document& document, Computation& computation, PanelDeck& deck, QObject* parent)
    : QObject(parent),
      m_ensemblePage(new widgets::EnsemblePage),
      m_causesPage(new widgets::CausesPage),
      m_ensemble(new EnsembleDisplay(document, computation, m_work, deck.ensemble(), *m_ensemblePage, this)),
      m_causes(new CausesDisplay(document, computation, m_work, *m_ensemble, deck.causes(), *m_causesPage, this)) {
    connect(&m_work, &StudyWork::begun, this, [this] {
        refresh();
        emit changed();
    });
    connect(&m_work, &StudyWork::ended, this, [this] {
        refresh();
        emit changed();
    });
    connect(m_ensemble, &EnsembleDisplay::told, this, &EvidenceStudies::told);
    connect(m_ensemble, &EnsembleDisplay::failed, this, &EvidenceStudies::failed);
    connect(m_causes, &CausesDisplay::told, this, &EvidenceStudies::told);
    connect(m_causes, &CausesDisplay::failed, this, &EvidenceStudies::failed);
    connect(m_causes, &CausesDisplay::saveChartRequested, this, &EvidenceStudies::saveChartRequested);
    connect(&deck.ensemble(), &widgets::EnsemblePanel::surfaceChanged, m_causes, &CausesDisplay::refresh);
}

EvidenceStudies::~EvidenceStudies() {
    m_work.forget();
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
