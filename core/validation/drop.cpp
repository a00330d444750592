#include "core/validation/drop.h"

#include <algorithm>
#include <functional>

#include "core/fe/loose_bodies.h"
#include "core/simulation/bodies/hand_over.h"
#include "core/simulation/run/collapse_run.h"
#include "core/trajectory/sink_relay.h"

namespace rubble {

namespace {

/// Bodies of the table in the order in which they enter: that of the clusters, less those that the engine cannot take.
std::vector<std::size_t> entryOrder(const RunDescription& description) {
    const std::vector<std::uint32_t> named = bodiesOfTable(*description.fe);
    std::vector<std::size_t> bodies;
    for (std::size_t c = 0; c < description.clustering->list.size(); ++c) {
        const ClusterId id = idAt<ClusterId>(c);
        if (bodyOf(description, id)) {
            const std::size_t element = at(description.fragments->list[at(description.clustering->membersOf(id).front())].element);
            bodies.push_back(named.empty() ? element : named[element]);
        }
    }
    return bodies;
}

TraceRequest requestOf(const DropWatch& watch, const std::vector<std::size_t>& order) {
    TraceRequest request{watch.samplesPerSecond, {}};
    for (const std::size_t body : order) {
        if (body < watch.asked.size()) {
            request.asked.push_back(watch.asked[body]);
        }
    }
    return request;
}

/// The world is gone once the run is: how bodies ended is read when its result is handed on.
class LastLook : public SinkRelay {
public:
    LastLook(TrajectorySink* next, std::function<void()> look) : SinkRelay(next), m_look(std::move(look)) {}
    void finish(const SimulationResult& simulation) override {
        m_look();
        SinkRelay::finish(simulation);
    }

private:
    std::function<void()> m_look;
};

Ending endingOf(const RigidWorld& world, BodyId body, const BodyTrace& trace, const TerrainGrid* terrain) {
    const Vec3& place = trace.latest.position;
    if (world.state(body) == BodyState::Removed) {
        return Ending::Lost;
    }
    if (terrain != nullptr && terrain->source(place.x(), place.y()) != TerrainGrid::Source::Raster) {
        return Ending::Left;
    }
    return world.state(body) == BodyState::Awake ? Ending::Moving : Ending::AtRest;
}

void measure(std::vector<DropOutcome>& bodies) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    const auto way = [](const DropOutcome& body) -> Vec3 { return body.trace.latest.position - body.trace.start.position; };
    for (DropOutcome& body : bodies) {
        body.runOut = way(body).head<2>().norm();
        body.fall = -way(body).z();
        mean += way(body).head<2>();
    }
    if (mean.norm() > 0.0) {
        mean.normalize();
        for (DropOutcome& body : bodies) {
            body.lateral = planeCross(mean, way(body).head<2>());
        }
    }
}

}  // namespace

std::string_view endingName(Ending ending) {
    switch (ending) {
        case Ending::AtRest:
            return "rest";
        case Ending::Moving:
            return "moving";
        case Ending::Left:
            return "left";
        case Ending::Lost:
            return "lost";
        case Ending::Refused:
            break;
    }
    return "refused";
}

std::int64_t DropResult::count(Ending ending) const {
    return std::count_if(bodies.begin(), bodies.end(), [ending](const DropOutcome& body) { return body.ending == ending; });
}

Pose placed(const LooseBody& body, const DropOutcome& outcome, const Pose& now) {
    const Pose& start = outcome.trace.start;
    // The engine turns a body about the principal axes of its inertia, which are those of its sides in another order.
    return {now.position, (now.orientation * start.orientation.conjugate() * body.pose.orientation).normalized()};
}

DropResult drop(const Inputs& inputs, const Scenario& scenario, const DropWatch& watch, TrajectorySink* sink,
                const Execution& execution) {
    DropResult result;
    result.results = run(inputs, scenario, Stage::Clusters, {}, nullptr, execution);
    const RunDescription description = describeRun(inputs, scenario, result.results);
    const std::vector<std::size_t> order = entryOrder(description);
    const auto& clusters = description.clustering->list;
    const double begin = clusters.empty() ? 0.0 : inputs.fe->times()[clusters.front().handOverState];
    std::vector<BodyTrace> traces;
    std::vector<Ending> endings;
    const RigidWorld* world = nullptr;
    LastLook relay(sink, [&] {
        for (std::size_t i = 0; i < traces.size(); ++i) {
            endings.push_back(endingOf(*world, idAt<BodyId>(i), traces[i], inputs.terrain.get()));
        }
    });
    const auto made = [&](const WorldSettings& settings) -> std::unique_ptr<RigidWorld> {
        auto watched =
            std::make_unique<WatchedWorld>(makeWorld(scenario.simulation.solver, settings), begin, requestOf(watch, order), traces);
        world = watched.get();
        return watched;
    };
    result.results.simulation = std::make_shared<const SimulationResult>(simulateIn(made, description, relay, execution));
    const std::vector<std::uint32_t> named = bodiesOfTable(*inputs.fe);
    result.bodies.resize(named.empty() ? inputs.fe->mesh().elementCount() : named.back() + std::size_t{1});
    for (std::size_t i = 0; i < std::min(endings.size(), order.size()); ++i) {
        DropOutcome& body = result.bodies[order[i]];
        body.ending = endings[i];
        body.trace = std::move(traces[i]);
    }
    measure(result.bodies);
    return result;
}

}  // namespace rubble
