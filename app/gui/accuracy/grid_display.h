#pragma once

#include <QObject>
#include <array>
#include <optional>

#include "app/gui/accuracy/grid_count.h"

namespace rubble {

class Computation;
class Document;
class Session;
class PanelDeck;

/// Keeps the Basic Grid panel and the drawn grid in step with a slider that moves: clusters are counted at once, and everything
/// that takes longer waits until it rests.
class GridDisplay : public QObject {
    Q_OBJECT

public:
    GridDisplay(Session& session, PanelDeck& deck, QObject* parent = nullptr);

    /// Sizes of the newest count, else of the results [m]; unset where there is no grid.
    std::optional<std::array<double, 3>> grid() const;
    /// Bodies of the scenario as it stands; unset while they are counted.
    std::optional<std::int64_t> bodies() const;
    /// The slider is held.
    bool dragging() const;

signals:
    /// The sizes or the bodies have changed.
    void changed();

private:
    void scenarioChanged();
    void prepared();
    void counted(const GridSettings& settings, const std::shared_ptr<const Sizing>& sizing);
    /// What is counted or was computed for the grid as it is set now; null while neither is there.
    std::shared_ptr<const Sizing> current() const;

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    PanelDeck& m_deck;
    std::shared_ptr<const Sizing> m_newest;
    GridSettings m_countedFor;
    const void* m_publishedOf = nullptr;  // fragments
    GridSettings m_publishedFor;
    GridCount m_count;
};

}  // namespace rubble
