#include <algorithm>
#include <iterator>
#include <mutex>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "io/json/case_migrations.h"
#include "io/run/frame_cache.h"
#include "io/run/run_columns.h"
#include "io/run/run_file.h"
#include "io/run/run_json.h"
#include "io/run/run_store.h"

namespace rubble::io {

namespace {

/// In the order in which they are looked at anew: what is written last comes first, so that whatever it names is seen as well.
constexpr std::array<RunDataset, 10> frameDatasets{
    RunDataset::Breaches, RunDataset::Islands,   RunDataset::IslandPlaces, RunDataset::IslandElements, RunDataset::Carriers,
    RunDataset::Bodies,   RunDataset::Positions, RunDataset::Orientations, RunDataset::Speeds,         RunDataset::States};

class RunFileReader : public RunReader {
public:
    RunFileReader(const std::string& path, std::size_t cacheBytes);

    std::size_t frameCount() const override;
    double frameTime(std::size_t i) const override;
    std::shared_ptr<const TrajectoryFrame> frame(std::size_t i) const override;
    std::vector<BodyRecord> bodies() const override;
    std::vector<Carrier> carriers() const override;
    std::vector<IslandRecord> islands() const override;
    bool complete() const override;
    const std::string& path() const override { return m_columns.path(); }
    const RunOrigin& origin() const override { return m_origin; }
    void refresh() override;
    void reopen() override;
    std::vector<LedgerRow> ledger() const override;
    std::vector<LedgerRow> islandLedger() const override;
    std::vector<IslandLoss> islandLosses() const override;
    std::vector<HealthBreach> breaches() const override;
    std::shared_ptr<const FragmentSet> fragments() const override;
    std::shared_ptr<const Clustering> clustering() const override;
    std::vector<std::string> componentNames() const override;
    std::vector<std::int64_t> elementIds() const override;
    std::shared_ptr<const SimulationResult> result() const override;
    std::shared_ptr<const Sizing> sizing() const override;
    Findings findings() const override;

private:
    /// What stands before the first step: read once, when asked for.
    struct Scene {
        std::shared_ptr<const FragmentSet> fragments;
        std::shared_ptr<const Clustering> clustering;
        std::shared_ptr<const Sizing> sizing;
        std::vector<std::string> components;
        std::vector<std::int64_t> elementIds;
        Findings componentFindings;
    };

    const Scene& scene() const;
    std::shared_ptr<FragmentSet> readFragments(std::size_t components) const;
    std::shared_ptr<Clustering> readClustering(const nlohmann::json& text, std::size_t fragments) const;
    void takeNewFrames();
    void takeNewBodies() const;
    void takeNewIslands() const;
    void takeNewBreaches() const;
    void takeBreach(const HealthBreach& breach) const;
    std::shared_ptr<const TrajectoryFrame> readFrame(const FrameRow& row) const;
    bool takeIfIntact(std::size_t index, const FrameRow& row);

    mutable std::mutex m_mutex;
    mutable RunColumns m_columns;
    RunOrigin m_origin;
    std::vector<FrameRow> m_frames;
    bool m_complete = false;
    mutable FrameCache m_cache;
    mutable std::unique_ptr<Scene> m_scene;
    mutable std::shared_ptr<const SimulationResult> m_result;
    mutable std::vector<BodyRecord> m_bodies;
    mutable std::vector<Carrier> m_carriers;
    mutable std::vector<IslandRecord> m_islands;
    mutable std::size_t m_breachText = 0;  ///< bytes of it that are taken
    mutable std::vector<HealthBreach> m_breaches;
};

RunFileReader::RunFileReader(const std::string& path, std::size_t cacheBytes) : m_columns(path), m_cache(cacheBytes) {
    nlohmann::json text = parseJson(m_columns.text(RunDataset::Origin), path + ": " + layoutOf(RunDataset::Origin).path);
    migrateScenario(text);
    m_origin = originFromJson(JsonCursor(text, path, layoutOf(RunDataset::Origin).path));
    refresh();
}

void RunFileReader::refresh() {
    const std::scoped_lock lock(m_mutex);
    if (m_complete) {
        return;
    }
    m_columns.refresh(RunDataset::Digests);
    if (m_columns.rows(RunDataset::Digests) > 0) {
        for (const RunDataset dataset : runDatasets()) {
            m_columns.refresh(dataset);
        }
        m_complete = true;
    }
    m_columns.refresh(RunDataset::Index);
    takeNewFrames();
}

void RunFileReader::reopen() {
    const std::scoped_lock lock(m_mutex);
    m_columns.reopen();
}

void RunFileReader::takeNewFrames() {
    const std::size_t known = m_frames.size();
    std::vector<FrameRow> rows = m_columns.list<FrameRow>(RunDataset::Index, known);
    if (rows.empty()) {
        return;
    }
    if (!m_complete) {
        for (const RunDataset dataset : frameDatasets) {
            m_columns.refresh(dataset);
        }
        // A writer that was stopped may have left an index row whose frame never came; all before an intact one are intact.
        while (!rows.empty() && !takeIfIntact(known + rows.size() - 1, rows.back())) {
            rows.pop_back();
        }
    }
    m_frames.insert(m_frames.end(), rows.begin(), rows.end());
}

bool RunFileReader::takeIfIntact(std::size_t index, const FrameRow& row) {
    try {
        auto frame = readFrame(row);
        if (!frame || row.bodies > m_columns.rows(RunDataset::Bodies)) {
            return false;
        }
        m_cache.add(index, std::move(frame));
        return true;
    } catch (const ParseError&) {
        return false;
    }
}

// Null if the frame's rows are not there or not what was written.
std::shared_ptr<const TrajectoryFrame> RunFileReader::readFrame(const FrameRow& row) const {
    for (const RunDataset dataset : {RunDataset::Positions, RunDataset::Orientations, RunDataset::Speeds, RunDataset::States}) {
        const std::uint64_t rows = m_columns.rows(dataset);
        if (row.offset > rows || row.bodies > rows - row.offset) {
            return nullptr;
        }
    }
    auto frame = std::make_shared<TrajectoryFrame>();
    frame->time = row.time;
    frame->kind =
        row.kind <= static_cast<std::uint32_t>(FrameKind::Illustrative) ? static_cast<FrameKind>(row.kind) : FrameKind::Simulated;
    frame->positions.resize(row.bodies);
    frame->orientations.resize(row.bodies);
    frame->speeds.resize(row.bodies);
    frame->states.resize(row.bodies);
    m_columns.read(RunDataset::Positions, row.offset, row.bodies, frame->positions.data());
    m_columns.read(RunDataset::Orientations, row.offset, row.bodies, frame->orientations.data());
    m_columns.read(RunDataset::Speeds, row.offset, row.bodies, frame->speeds.data());
    m_columns.read(RunDataset::States, row.offset, row.bodies, frame->states.data());
    return frameChecksum(*frame) == row.checksum ? frame : nullptr;
}

std::size_t RunFileReader::frameCount() const {
    const std::scoped_lock lock(m_mutex);
    return m_frames.size();
}

double RunFileReader::frameTime(std::size_t i) const {
    const std::scoped_lock lock(m_mutex);
    return m_frames.at(i).time;
}

std::shared_ptr<const TrajectoryFrame> RunFileReader::frame(std::size_t i) const {
    const std::scoped_lock lock(m_mutex);
    if (auto known = m_cache.find(i)) {
        return known;
    }
    const FrameRow& row = m_frames.at(i);
    std::shared_ptr<const TrajectoryFrame> frame = readFrame(row);
    if (!frame) {
        throw ParseError(
            Message{"io.run.frame", "{0}: frame {1} at {2} is damaged", {m_columns.path(), i, Argument(row.time, "s")}},
            Message{"io.run.damaged.remedy", "Run the case again, or take a good copy of the run file.", {}});
    }
    m_cache.add(i, frame);
    return frame;
}

void RunFileReader::takeNewBodies() const {
    const std::vector<BodyRecord> bodies = m_columns.table<BodyRecord>(RunDataset::Bodies, m_bodies.size());
    const std::vector<Carrier> carriers = m_columns.table<Carrier>(RunDataset::Carriers, m_carriers.size());
    const std::size_t bodyCount = m_columns.rows(RunDataset::Bodies);
    const std::size_t fragmentCount = m_columns.rows(RunDataset::Fragments);
    for (const Carrier& carrier : carriers) {
        if (at(carrier.fragment) >= fragmentCount || at(carrier.body) >= bodyCount) {
            m_columns.failContent(RunDataset::Carriers, "it names a fragment or a body that does not exist");
        }
    }
    m_bodies.insert(m_bodies.end(), bodies.begin(), bodies.end());
    m_carriers.insert(m_carriers.end(), carriers.begin(), carriers.end());
    if (!carriers.empty()) {
        endReplaced(m_bodies, m_carriers);
    }
}

std::vector<BodyRecord> RunFileReader::bodies() const {
    const std::scoped_lock lock(m_mutex);
    takeNewBodies();
    return m_bodies;
}

std::vector<Carrier> RunFileReader::carriers() const {
    const std::scoped_lock lock(m_mutex);
    takeNewBodies();
    return m_carriers;
}

void RunFileReader::takeNewIslands() const {
    const std::size_t known = m_islands.size();
    const std::vector<IslandRow> rows = m_columns.table<IslandRow>(RunDataset::Islands, known);
    if (rows.empty()) {
        return;
    }
    takeNewBodies();
    const std::vector<IslandPlaceRow> places = m_columns.table<IslandPlaceRow>(RunDataset::IslandPlaces, known);
    const bool placed = m_columns.has(RunDataset::IslandPlaces);
    if (placed && places.size() < rows.size()) {
        m_columns.failContent(RunDataset::IslandPlaces, "it does not have one row for each island");
    }
    // Elements stand island by island, as rows do.
    const std::size_t from = rows.front().firstElement;
    const std::vector<ElementIndex> elements = m_columns.list<ElementIndex>(RunDataset::IslandElements, from);
    std::vector<IslandRecord> islands;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const IslandRow& row = rows[i];
        const std::size_t first = row.firstElement - from;
        if (row.body >= m_bodies.size() || row.firstElement < from || first > elements.size() ||
            row.elementCount > elements.size() - first) {
            m_columns.failContent(RunDataset::Islands, "it names a body or elements that do not exist");
        }
        IslandPlaceRow place{atLastState, m_bodies[row.body].atBirth};
        if (placed) {
            place = places[i];
        }
        const auto begin = elements.begin() + static_cast<std::ptrdiff_t>(first);
        islands.push_back({idAt<BodyId>(row.body), place.state, place.inFe, {begin, begin + row.elementCount}});
    }
    std::ranges::move(islands, std::back_inserter(m_islands));
}

std::vector<IslandRecord> RunFileReader::islands() const {
    const std::scoped_lock lock(m_mutex);
    takeNewIslands();
    return m_islands;
}

bool RunFileReader::complete() const {
    const std::scoped_lock lock(m_mutex);
    return m_complete;
}

std::vector<LedgerRow> RunFileReader::ledger() const {
    const std::scoped_lock lock(m_mutex);
    m_columns.refresh(RunDataset::Ledger);
    return m_columns.table<LedgerRow>(RunDataset::Ledger);
}

std::vector<LedgerRow> RunFileReader::islandLedger() const {
    const std::scoped_lock lock(m_mutex);
    m_columns.refresh(RunDataset::IslandLedger);
    return m_columns.table<LedgerRow>(RunDataset::IslandLedger);
}

std::vector<IslandLoss> RunFileReader::islandLosses() const {
    const std::scoped_lock lock(m_mutex);
    m_columns.refresh(RunDataset::IslandLosses);
    return m_columns.table<IslandLoss>(RunDataset::IslandLosses);
}

void RunFileReader::takeNewBreaches() const {
    const std::string place = layoutOf(RunDataset::Breaches).path;
    std::string text(m_columns.rows(RunDataset::Breaches) - m_breachText, '\0');
    m_columns.read(RunDataset::Breaches, m_breachText, text.size(), text.data());
    std::size_t from = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', from)) {
        try {
            const nlohmann::json line = parseJson(text.substr(from, end - from), m_columns.path() + ": " + place);
            takeBreach(breachFromJson(JsonCursor(line, m_columns.path(), place)));
        } catch (const ParseError&) {
            break;  // a writer that was stopped may have left a line that never came; the frames are intact without it
        }
        from = end + 1;
    }
    m_breachText += from;
}

void RunFileReader::takeBreach(const HealthBreach& breach) const {
    const auto before = [](const HealthBreach& a, const HealthBreach& b) {
        return a.from != b.from ? a.from < b.from : a.check < b.check;
    };
    const auto place = std::lower_bound(m_breaches.begin(), m_breaches.end(), breach, before);
    if (place != m_breaches.end() && !before(breach, *place)) {
        *place = breach;
    } else {
        m_breaches.insert(place, breach);
    }
}

std::vector<HealthBreach> RunFileReader::breaches() const {
    if (const auto outcome = result()) {
        return outcome->health.breaches;
    }
    const std::scoped_lock lock(m_mutex);
    takeNewBreaches();
    return m_breaches;
}

std::shared_ptr<FragmentSet> RunFileReader::readFragments(std::size_t components) const {
    auto set = std::make_shared<FragmentSet>();
    set->list = m_columns.table<Fragment>(RunDataset::Fragments);
    const std::size_t count = set->list.size();
    for (const Fragment& fragment : set->list) {
        if (at(fragment.component) >= std::max<std::size_t>(components, 1)) {
            m_columns.failContent(RunDataset::Fragments, "a fragment names a component that does not exist");
        }
    }
    set->vertices = m_columns.list<Vec3>(RunDataset::Vertices);
    set->vertexOffsets = m_columns.list<std::uint32_t>(RunDataset::VertexOffsets);
    const bool whole = count == 0 ? set->vertices.empty()
                                  : set->vertexOffsets.size() == count + 1 && set->vertexOffsets.back() == set->vertices.size() &&
                                        std::is_sorted(set->vertexOffsets.begin(), set->vertexOffsets.end());
    if (!whole) {
        m_columns.failContent(RunDataset::VertexOffsets, "it does not match the vertices");
    }
    set->solid = m_columns.list<ElementShape>(RunDataset::Solids);
    if (set->solid.size() != count) {
        m_columns.failContent(RunDataset::Solids, "it does not have one row for each fragment");
    }
    for (std::size_t f = 0; f < count; ++f) {
        const auto corners = set->vertexOffsets[f + 1] - set->vertexOffsets[f];
        if (!isSolid(set->solid[f]) || static_cast<std::uint32_t>(cornerCount(set->solid[f])) != corners) {
            m_columns.failContent(RunDataset::Solids, "a solid does not have the corners of its shape");
        }
    }
    return set;
}

std::shared_ptr<Clustering> RunFileReader::readClustering(const nlohmann::json& text, std::size_t fragments) const {
    auto clustering = std::make_shared<Clustering>(clusteringFromJson(
        JsonCursor(text, m_columns.path(), std::string(layoutOf(RunDataset::Description).path) + "/clustering")));
    clustering->list = m_columns.table<Cluster>(RunDataset::Clusters);
    clustering->members = m_columns.list<FragmentId>(RunDataset::ClusterMembers);
    clustering->of = m_columns.list<ClusterId>(RunDataset::ClusterOf);
    const auto known = [](std::size_t limit) { return [limit](auto id) { return at(id) < limit; }; };
    if (!std::all_of(clustering->members.begin(), clustering->members.end(), known(fragments))) {
        m_columns.failContent(RunDataset::ClusterMembers, "it names a fragment that does not exist");
    }
    if (!std::all_of(clustering->of.begin(), clustering->of.end(), known(clustering->list.size()))) {
        m_columns.failContent(RunDataset::ClusterOf, "it names a cluster that does not exist");
    }
    for (const Cluster& cluster : clustering->list) {
        if (cluster.firstMember > clustering->members.size() ||
            cluster.memberCount > clustering->members.size() - cluster.firstMember) {
            m_columns.failContent(RunDataset::Clusters, "a cluster has members that do not exist");
        }
    }
    return clustering;
}

const RunFileReader::Scene& RunFileReader::scene() const {
    static const Scene nothing;
    if (m_scene) {
        return *m_scene;
    }
    m_columns.refresh(RunDataset::Description);
    if (m_columns.rows(RunDataset::Description) == 0) {
        return nothing;
    }
    for (const RunDataset dataset : runDatasets()) {
        m_columns.refresh(dataset);
    }
    const std::string place = layoutOf(RunDataset::Description).path;
    const nlohmann::json text = parseJson(m_columns.text(RunDataset::Description), m_columns.path() + ": " + place);
    const JsonCursor top(text, m_columns.path(), place);
    auto scene = std::make_unique<Scene>();
    for (const JsonCursor& name : top["components"].elements()) {
        scene->components.push_back(name.text());
    }
    auto fragments = readFragments(scene->components.size());
    fragments->findings = findingsFromJson(top["fragment_findings"]);
    scene->elementIds = m_columns.list<std::int64_t>(RunDataset::ElementIds);
    if (scene->elementIds.size() != fragments->size()) {
        m_columns.failContent(RunDataset::ElementIds, "it does not have one row for each fragment");
    }
    scene->componentFindings = findingsFromJson(top["component_findings"]);
    if (!top["clustering"].value().is_null()) {
        scene->clustering = readClustering(top["clustering"].value(), fragments->size());
    }
    if (!top["sizing"].value().is_null()) {
        scene->sizing = std::make_shared<Sizing>(sizingFromJson(top["sizing"]));
    }
    scene->fragments = std::move(fragments);
    m_scene = std::move(scene);
    return *m_scene;
}

std::shared_ptr<const FragmentSet> RunFileReader::fragments() const {
    const std::scoped_lock lock(m_mutex);
    return scene().fragments;
}

std::shared_ptr<const Clustering> RunFileReader::clustering() const {
    const std::scoped_lock lock(m_mutex);
    return scene().clustering;
}

std::vector<std::string> RunFileReader::componentNames() const {
    const std::scoped_lock lock(m_mutex);
    return scene().components;
}

std::vector<std::int64_t> RunFileReader::elementIds() const {
    const std::scoped_lock lock(m_mutex);
    return scene().elementIds;
}

std::shared_ptr<const Sizing> RunFileReader::sizing() const {
    const std::scoped_lock lock(m_mutex);
    return scene().sizing;
}

std::shared_ptr<const SimulationResult> RunFileReader::result() const {
    const std::scoped_lock lock(m_mutex);
    if (!m_complete || m_result) {
        return m_result;
    }
    const std::string place = layoutOf(RunDataset::Result).path;
    const nlohmann::json text = parseJson(m_columns.text(RunDataset::Result), m_columns.path() + ": " + place);
    auto result = std::make_shared<SimulationResult>(resultFromJson(JsonCursor(text, m_columns.path(), place)));
    result->fragments = m_columns.table<FragmentOutcome>(RunDataset::Outcomes);
    m_result = std::move(result);
    return m_result;
}

Findings RunFileReader::findings() const {
    Findings all;
    {
        const std::scoped_lock lock(m_mutex);
        const Scene& known = scene();
        all.append(known.componentFindings);
        if (known.fragments) {
            all.append(known.fragments->findings);
        }
        if (known.sizing) {
            all.append(known.sizing->findings);
        }
        if (known.clustering) {
            all.append(known.clustering->findings);
        }
    }
    if (const auto outcome = result()) {
        all.append(outcome->findings);
    }
    return all;
}

}  // namespace

std::shared_ptr<RunReader> openRun(const std::string& path, std::size_t cacheBytes) {
    return std::make_shared<RunFileReader>(path, cacheBytes);
}

}  // namespace rubble::io
