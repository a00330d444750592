#include <sys/resource.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "core/base/archive.h"
#include "core/base/error.h"
#include "io/run/run_columns.h"
#include "io/run/run_file.h"
#include "io/run/run_json.h"
#include "io/run/run_store.h"
#include "io/run/run_tables.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

// Committed frames reach the operating system this often when there are many new rows, and this often at least. A flush compresses
// unfinished chunks before their time and costs space, so it should be worth it.
constexpr std::chrono::milliseconds flushInterval{400};
constexpr std::chrono::milliseconds slowFlushInterval{2000};
// Rows of the long lists written at a time, so that a reader never waits long for the lock.
constexpr std::size_t listBlock = 8192;
// Frames that wait for the writing thread at most; beyond that the simulation waits.
constexpr std::size_t queueBytes = std::size_t{16} << 20;

static_assert(sizeof(Eigen::Vector3f) == 12 && sizeof(Eigen::Quaternionf) == 16 && sizeof(BodyState) == 1);

/// Lets this thread run where others leave room: writing can wait, threads that simulate wait for each other.
void giveWay() {
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), 10);
}

std::size_t sizeOf(const TrajectoryFrame& frame) {
    return frame.bodies() * 33;
}

/// Does the writing jobs in the order in which they came, on a thread of its own: compressing a frame takes longer than the
/// simulation should wait. The first error stops all further work and is thrown at the next call.
class JobThread {
public:
    JobThread() : m_thread([this] { work(); }) {}
    ~JobThread() {
        {
            const std::scoped_lock lock(m_mutex);
            m_closing = true;
        }
        m_changed.notify_all();
        m_thread.join();
    }

    /// Waits while more than queueBytes are under way; throws what an earlier job threw.
    void add(std::size_t bytes, std::function<void()> job) {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [this] { return m_bytes <= queueBytes; });
        rethrow();
        m_bytes += bytes;
        m_jobs.push_back({bytes, std::move(job)});
        m_changed.notify_all();
    }
    /// Waits until everything is done; throws what a job threw.
    void drain() {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [this] { return m_jobs.empty() && !m_busy; });
        rethrow();
    }

private:
    struct Job {
        std::size_t bytes = 0;
        std::function<void()> work;
    };

    void rethrow() const {
        if (m_error) {
            std::rethrow_exception(m_error);
        }
    }

    void work() {
        giveWay();
        std::unique_lock lock(m_mutex);
        for (;;) {
            m_changed.wait(lock, [this] { return m_closing || !m_jobs.empty(); });
            if (m_jobs.empty()) {
                return;
            }
            Job job = std::move(m_jobs.front());
            m_jobs.pop_front();
            m_busy = true;
            const bool failed = m_error != nullptr;
            lock.unlock();
            std::exception_ptr error;
            try {
                if (!failed) {
                    job.work();
                }
            } catch (...) {
                error = std::current_exception();
            }
            job.work = nullptr;
            lock.lock();
            m_busy = false;
            m_bytes -= job.bytes;
            if (error) {
                m_error = error;
            }
            m_changed.notify_all();
        }
    }

    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<Job> m_jobs;
    std::size_t m_bytes = 0;
    bool m_busy = false;
    bool m_closing = false;
    std::exception_ptr m_error;
    std::thread m_thread;  // last: starts when everything else stands
};

class RunWriter : public TrajectorySink {
public:
    /// @param interrupted  a file that the run may go on from; empty: none
    RunWriter(const std::string& path, const RunOrigin& origin, const std::string& interrupted)
        : m_path(path), m_interrupted(interrupted), m_origin(jsonText(originJson(origin))) {
        m_store.emplace(m_path, m_origin);
    }
    ~RunWriter() override;

    void begin(const RunDescription& description) override;
    void addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) override;
    void addIslands(std::span<const IslandRecord> islands, const LedgerRow& ledger) override;
    void addIslandLoss(const IslandLoss& loss) override;
    void commit(const TrajectoryFrame& frame) override;
    void addLedger(const LedgerRow& row) override;
    void addBreaches(const std::vector<HealthBreach>& breaches) override;
    void finish(const SimulationResult& result) override;
    std::optional<std::string> mark() override;
    bool resume(const RunDescription& description, std::string_view mark) override;

private:
    template <class T>
    void writeList(RunDataset dataset, std::span<const T> rows);
    template <class T>
    void writeTable(RunDataset dataset, std::span<const T> rows);
    void writeFragments(const RunDescription& description);
    void writeFrame(const TrajectoryFrame& frame);
    void writeResult(const SimulationResult& result);
    void flushFrames();
    void keepMark(Archive& archive);
    bool takeOver(const std::vector<DatasetDigest>& known);
    void dropInterrupted();

    const std::string m_path;
    const std::string m_interrupted;
    const std::string m_origin;
    std::optional<RunStore> m_store;
    std::uint64_t m_rows = 0;         // of all committed frames
    std::uint64_t m_flushedRows = 0;  // of these, handed to the operating system
    std::size_t m_bodies = 0;
    std::size_t m_islandElements = 0;  // of all islands so far
    double m_lastTime = -std::numeric_limits<double>::infinity();
    bool m_finished = false;
    std::chrono::steady_clock::time_point m_flushed = std::chrono::steady_clock::now();
    JobThread m_jobs;  // last: its jobs use what stands above
};

RunWriter::~RunWriter() {
    // After a cancel what was committed still goes out; an error here has nobody to go to, and the file stays readable.
    try {
        m_jobs.add(0, [this] {
            if (!m_finished && m_store) {
                flushFrames();
                m_store->flushAll();
            }
        });
        m_jobs.drain();
    } catch (const std::exception&) {
        return;
    }
}

template <class T>
void RunWriter::writeList(RunDataset dataset, std::span<const T> rows) {
    assert(layoutOf(dataset).rowBytes == sizeof(T));
    for (std::size_t from = 0; from < rows.size(); from += listBlock) {
        m_store->append(dataset, rows.data() + from, std::min(listBlock, rows.size() - from));
    }
}

template <class T>
void RunWriter::writeTable(RunDataset dataset, std::span<const T> rows) {
    for (std::size_t from = 0; from < rows.size(); from += listBlock) {
        const std::span<const T> block = rows.subspan(from, std::min(listBlock, rows.size() - from));
        m_store->append(dataset, packRows(block).data(), block.size());
    }
}

void RunWriter::writeFragments(const RunDescription& description) {
    const FragmentSet& fragments = *description.fragments;
    writeTable<Fragment>(RunDataset::Fragments, fragments.list);
    writeList<Vec3>(RunDataset::Vertices, fragments.vertices);
    writeList<std::uint32_t>(RunDataset::VertexOffsets, fragments.vertexOffsets);
    writeList<ElementShape>(RunDataset::Solids, fragments.solid);
    std::vector<std::int64_t> elementIds;
    elementIds.reserve(fragments.size());
    for (const Fragment& fragment : fragments.list) {
        const bool known = description.fe && at(fragment.element) < description.fe->mesh().elementIds.size();
        elementIds.push_back(known ? description.fe->mesh().elementIds[at(fragment.element)]
                                   : static_cast<std::int64_t>(at(fragment.element)) + 1);
    }
    writeList<std::int64_t>(RunDataset::ElementIds, elementIds);
}

void RunWriter::begin(const RunDescription& given) {
    dropInterrupted();
    m_jobs.add(0, [this, description = given] {
        nlohmann::json text = {{"components", nlohmann::json::array()},
                               {"sizing", nullptr},
                               {"clustering", nullptr},
                               {"component_findings", nlohmann::json::array()},
                               {"fragment_findings", nlohmann::json::array()},
                               {"fingerprint", description.fingerprint.hex()}};
        if (description.components) {
            for (const Component& component : description.components->list) {
                text["components"].push_back(component.name);
            }
            text["component_findings"] = findingsJson(description.components->findings);
        }
        if (description.fragments) {
            writeFragments(description);
            text["fragment_findings"] = findingsJson(description.fragments->findings);
        }
        if (description.clustering) {
            const Clustering& clustering = *description.clustering;
            writeTable<Cluster>(RunDataset::Clusters, clustering.list);
            writeList<FragmentId>(RunDataset::ClusterMembers, clustering.members);
            writeList<ClusterId>(RunDataset::ClusterOf, clustering.of);
            text["clustering"] = clusteringJson(clustering);
        }
        if (description.sizing) {
            text["sizing"] = sizingJson(*description.sizing);
        }
        m_store->appendText(RunDataset::Description, jsonText(text));
        m_store->flushAll();
    });
    m_jobs.drain();
}

void RunWriter::addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) {
    m_jobs.add(0, [this, packedBodies = packRows(bodies), packedCarriers = packRows(carriers)] {
        m_store->append(RunDataset::Bodies, packedBodies.data(), packedBodies.size() / columnCount<BodyRecord>());
        m_store->append(RunDataset::Carriers, packedCarriers.data(), packedCarriers.size() / columnCount<Carrier>());
    });
    m_bodies += bodies.size();
}

void RunWriter::addIslands(std::span<const IslandRecord> islands, const LedgerRow& ledger) {
    std::vector<IslandRow> rows;
    std::vector<IslandPlaceRow> places;
    std::vector<ElementIndex> elements;
    for (const IslandRecord& island : islands) {
        rows.push_back({static_cast<std::uint32_t>(island.body), static_cast<std::uint32_t>(m_islandElements + elements.size()),
                        static_cast<std::uint32_t>(island.elements.size())});
        places.push_back({island.state, island.inFe});
        elements.insert(elements.end(), island.elements.begin(), island.elements.end());
    }
    m_islandElements += elements.size();
    const std::size_t bytes = elements.size() * sizeof(ElementIndex);
    m_jobs.add(bytes, [this, rows = std::move(rows), places = std::move(places), elements = std::move(elements), ledger] {
        writeList<ElementIndex>(RunDataset::IslandElements, elements);
        writeTable<IslandPlaceRow>(RunDataset::IslandPlaces, places);
        writeTable<IslandRow>(RunDataset::Islands, rows);
        writeTable<LedgerRow>(RunDataset::IslandLedger, std::span(&ledger, 1));
    });
}

void RunWriter::addIslandLoss(const IslandLoss& loss) {
    m_jobs.add(0, [this, loss] { writeTable<IslandLoss>(RunDataset::IslandLosses, std::span(&loss, 1)); });
}

void RunWriter::commit(const TrajectoryFrame& frame) {
    assert(frame.orientations.size() == frame.bodies() && frame.speeds.size() == frame.bodies() &&
           frame.states.size() == frame.bodies() && frame.bodies() <= m_bodies);
    assert(frame.time >= m_lastTime);
    m_lastTime = frame.time;
    m_jobs.add(sizeOf(frame), [this, frame] { writeFrame(frame); });
}

void RunWriter::writeFrame(const TrajectoryFrame& frame) {
    FrameRow row{frame.time, m_rows, frameChecksum(frame), static_cast<std::uint32_t>(frame.bodies()),
                 static_cast<std::uint32_t>(frame.kind)};
    m_store->append(RunDataset::Positions, frame.positions.data(), frame.bodies());
    m_store->append(RunDataset::Orientations, frame.orientations.data(), frame.bodies());
    m_store->append(RunDataset::Speeds, frame.speeds.data(), frame.bodies());
    m_store->append(RunDataset::States, frame.states.data(), frame.bodies());
    m_store->append(RunDataset::Index, &row, 1);
    m_rows += frame.bodies();
    const auto waited = std::chrono::steady_clock::now() - m_flushed;
    const bool much = m_rows - m_flushedRows >= layoutOf(RunDataset::Positions).chunkRows;
    if (waited >= slowFlushInterval || (much && waited >= flushInterval)) {
        flushFrames();
    }
}

void RunWriter::flushFrames() {
    // The index goes last: whoever finds a row in it finds the frame as well.
    for (const RunDataset dataset :
         {RunDataset::Bodies, RunDataset::Carriers, RunDataset::IslandElements, RunDataset::IslandPlaces, RunDataset::Islands,
          RunDataset::IslandLedger, RunDataset::IslandLosses, RunDataset::Ledger, RunDataset::Breaches, RunDataset::Positions,
          RunDataset::Orientations, RunDataset::Speeds, RunDataset::States, RunDataset::Index}) {
        m_store->flush(dataset);
    }
    m_flushed = std::chrono::steady_clock::now();
    m_flushedRows = m_rows;
}

void RunWriter::addLedger(const LedgerRow& row) {
    m_jobs.add(0, [this, packed = packRows(std::span(&row, 1))] { m_store->append(RunDataset::Ledger, packed.data(), 1); });
}

void RunWriter::addBreaches(const std::vector<HealthBreach>& breaches) {
    std::string lines;
    for (const HealthBreach& breach : breaches) {
        lines += jsonLine(breachJson(breach)) + '\n';
    }
    m_jobs.add(lines.size(), [this, lines] { m_store->appendText(RunDataset::Breaches, lines); });
}

void RunWriter::writeResult(const SimulationResult& result) {
    writeTable<FragmentOutcome>(RunDataset::Outcomes, result.fragments);
    m_store->appendText(RunDataset::Result, jsonText(resultJson(result)));
    flushFrames();
    m_store->flushAll();
    // The digests say that the run is complete, so they are the very last.
    m_store->appendText(RunDataset::Digests, m_store->digestsText());
    m_store->flushAll();
    m_store->close();
}

void RunWriter::finish(const SimulationResult& result) {
    m_jobs.add(0, [this, &result] {
        writeResult(result);
        m_finished = true;
    });
    m_jobs.drain();
}

void RunWriter::dropInterrupted() {
    std::error_code ignored;
    if (!m_interrupted.empty()) {
        fs::remove(m_interrupted, ignored);
    }
}

/// How far the run is, beside its datasets.
void RunWriter::keepMark(Archive& archive) {
    archive(m_rows, m_bodies, m_islandElements, m_lastTime);
}

std::optional<std::string> RunWriter::mark() {
    m_jobs.drain();
    flushFrames();
    m_store->flushAll();
    Archive archive;
    keepMark(archive);
    for (const RunDataset dataset : runDatasets()) {
        DatasetDigest known = m_store->digestOf(dataset);
        archive(known.rows, known.hash.bytes);
    }
    return std::move(archive).take();
}

bool RunWriter::resume(const RunDescription&, std::string_view mark) {
    Archive archive(mark);
    keepMark(archive);
    std::vector<DatasetDigest> known;
    for (const RunDataset dataset : runDatasets()) {
        DatasetDigest& one = known.emplace_back();
        one.dataset = dataset;
        archive(one.rows, one.hash.bytes);
    }
    bool taken = false;
    try {
        taken = takeOver(known);
    } catch (const ParseError&) {
        // What cannot be read is not there.
    } catch (const WorldError&) {
    }
    if (!taken) {
        m_store.reset();
        m_store.emplace(m_path, m_origin);
        m_rows = m_bodies = m_islandElements = 0;
        m_lastTime = -std::numeric_limits<double>::infinity();
        return false;
    }
    flushFrames();
    m_store->flushAll();
    dropInterrupted();
    return true;
}

/// Takes the rows that a checkpoint knows of from the file of the interrupted run. False: they are not what they were.
bool RunWriter::takeOver(const std::vector<DatasetDigest>& known) {
    constexpr std::size_t blockBytes = std::size_t{4} << 20;
    const RunColumns interrupted(m_interrupted);
    std::vector<std::byte> block;
    for (const DatasetDigest& one : known) {
        const std::size_t rowBytes = layoutOf(one.dataset).rowBytes;
        if (interrupted.rows(one.dataset) < one.rows) {
            return false;
        }
        for (std::uint64_t from = m_store->digestOf(one.dataset).rows; from < one.rows;) {
            const std::uint64_t count = std::min<std::uint64_t>(one.rows - from, std::max<std::size_t>(1, blockBytes / rowBytes));
            block.resize(count * rowBytes);
            interrupted.read(one.dataset, from, count, block.data());
            m_store->append(one.dataset, block.data(), count);
            from += count;
        }
        const DatasetDigest taken = m_store->digestOf(one.dataset);
        if (taken.rows != one.rows || taken.hash != one.hash) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::string checkpointPathOf(const std::string& runPath) {
    return runPath + ".checkpoint";
}

std::unique_ptr<TrajectorySink> createRun(const std::string& path, const RunOrigin& origin) {
    return std::make_unique<RunWriter>(path, origin, "");
}

std::unique_ptr<TrajectorySink> continueRun(const std::string& path, const RunOrigin& origin) {
    const std::string interrupted = path + ".interrupted";
    std::error_code ignored;
    if (!fs::exists(checkpointPathOf(path), ignored)) {
        // Nor is there anything to take over: it would be taken for the next run that is stopped.
        fs::remove(interrupted, ignored);
        return createRun(path, origin);
    }
    // One that lies there already was set aside by a process that was stopped before it had taken it over.
    if (!fs::exists(interrupted, ignored)) {
        fs::rename(path, interrupted, ignored);
    }
    return std::make_unique<RunWriter>(path, origin, interrupted);
}

}  // namespace rubble::io
