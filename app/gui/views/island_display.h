#pragma once

#include <QObject>
#include <memory>

#include "app/gui/session/worker.h"
#include "core/pipeline/loose_scene.h"

namespace rubble {

class Computation;
class Document;
class Session;

/// Looks for the loose islands of the FE result while structure is coloured by them. Works on a thread of its own.
class IslandDisplay : public QObject {
    Q_OBJECT

public:
    explicit IslandDisplay(Session& session, QObject* parent = nullptr);

    /// What views tell apart; null: nothing, or not found yet.
    std::shared_ptr<const LooseStructure> loose() const;
    /// The same for a run of another scenario; null as well where that has other islands.
    std::shared_ptr<const LooseStructure> looseOf(const Scenario& scenario) const;
    /// They are looked for.
    bool busy() const { return m_worker.busy(); }
    /// Structure is coloured by island, or no longer.
    void setShown(bool shown);
    /// The FE result or the scenario has changed.
    void refresh();

signals:
    /// There are other islands to tell apart.
    void changed();

private:
    /// What islands depend on.
    struct Scene {
        std::weak_ptr<const FeResult> fe;
        std::weak_ptr<const TerrainGrid> terrain;
        Revival revival = Revival::Latch;
        bool level = true;
        double levelHeight = 0.0;  ///< m

        bool operator==(const Scene& other) const;
    };
    /// What outlives the window.
    struct Kept {
        Scene scene;  ///< that was looked through, or is
        std::shared_ptr<const LooseStructure> loose;
    };
    Scene sceneOf(const Scenario& scenario) const;

    Document& m_document;
    Computation& m_computation;
    Kept& m_kept;
    bool m_shown = false;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
