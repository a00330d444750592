#include "app/gui/accuracy/grid_display.h"

#include "app/gui/session/session.h"
#include "app/gui/stage/panel_deck.h"

namespace rubble {

GridDisplay::GridDisplay(Session& session, PanelDeck& deck, QObject* parent)
    : QObject(parent), m_session(session), m_document(session.document()), m_computation(session.computation()), m_deck(deck) {
    connect(&m_document, &Document::scenarioChanged, this, &GridDisplay::scenarioChanged);
    connect(&m_computation, &Computation::prepared, this, &GridDisplay::prepared);
    connect(&m_count, &GridCount::counted, this, &GridDisplay::counted);
    connect(&m_count, &GridCount::publishedCounted, &m_deck.grid(), &widgets::GridPanel::setPublishedCounts);
    prepared();
}

bool GridDisplay::dragging() const {
    return m_deck.grid().dragging();
}

void GridDisplay::scenarioChanged() {
    const GridSettings& settings = m_document.scenario().grid;
    if (!m_count.ready() || (m_newest != nullptr && m_countedFor == settings)) {
        return;
    }
    // A search takes a second, and the computation makes one anyway.
    const bool searched =
        !settings.oneBodyPerFragment && !settings.multiple && !(settings.length && settings.width && settings.height);
    if (!searched) {
        m_count.count(settings);
    }
    emit changed();
}

void GridDisplay::prepared() {
    const Results& results = m_computation.results();
    const bool anew = m_computation.inputs().fe == nullptr || results.fragments == nullptr;
    m_count.setScene(m_computation.inputs().fe, anew ? nullptr : results.fragments, results.components);
    const GridSettings& settings = m_document.scenario().grid;
    if (anew) {
        m_newest.reset();
        m_publishedOf = nullptr;
        m_deck.grid().setPublishedCounts({});
    } else if (results.sizing != nullptr && !m_computation.stale(Stage::Sizing, m_document.scenario())) {
        m_newest = results.sizing;
        m_countedFor = settings;
        GridSettings asked = settings;
        asked.multiple = asked.length = asked.width = asked.height = std::nullopt;
        if (m_publishedOf != results.fragments.get() || !(m_publishedFor == asked)) {
            m_publishedOf = results.fragments.get();
            m_publishedFor = asked;
            m_count.countPublished(asked);
        }
    }
    emit changed();
}

void GridDisplay::counted(const GridSettings& settings, const std::shared_ptr<const Sizing>& sizing) {
    m_newest = sizing;
    m_countedFor = settings;
    const Results& results = m_computation.results();
    // What was computed in full says more.
    if (dragging() || m_computation.stale(Stage::Clusters, m_document.scenario())) {
        const auto& fe = m_computation.inputs().fe;
        m_deck.grid().setContent(
            {sizing, results.clustering, results.fragments, results.components, fe != nullptr ? &fe->mesh() : nullptr, true});
    }
    emit changed();
}

std::shared_ptr<const Sizing> GridDisplay::current() const {
    return m_newest != nullptr && m_countedFor == m_document.scenario().grid ? m_newest : nullptr;
}

std::optional<std::array<double, 3>> GridDisplay::grid() const {
    const std::shared_ptr<const Sizing>& sizing = m_newest;
    if (sizing == nullptr || m_document.scenario().grid.oneBodyPerFragment || !(sizing->grid.l > 0.0)) {
        return std::nullopt;
    }
    return std::array{sizing->grid.l, sizing->grid.w, sizing->grid.h};
}

std::optional<std::int64_t> GridDisplay::bodies() const {
    const std::shared_ptr<const Sizing> sizing = current();
    return sizing != nullptr ? std::optional(static_cast<std::int64_t>(sizing->clusters)) : std::nullopt;
}

}  // namespace rubble
