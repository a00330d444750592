#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "core/base/message.h"
#include "core/scenario/case.h"
#include "core/simulation/run/simulation.h"
#include "core/trajectory/trajectory.h"

namespace rubble::io {

/// A file that a run was made from.
struct RecordedInput {
    std::string path;  ///< absolute
    std::string sha256;
    Vec3 offset = Vec3::Zero();  ///< m, added to the coordinates of a mesh
    CloudRequest read = {};      ///< of a point cloud
};

/// Where a run came from, kept inside the run file so that it can be verified and exported later.
struct RunOrigin {
    std::string fePath;  ///< absolute
    std::string feSha256;
    std::string terrainPath;  ///< absolute; empty if the run had none
    std::string terrainSha256;
    CloudRequest terrainRead;                 ///< of a terrain that is a point cloud
    Site site;                                ///< how it was brought to the local frame
    std::vector<RecordedInput> surroundings;  ///< that debris fell on as well
    Frame frame;
    Scenario scenario;
    std::string scenarioName;
    std::string build;
    Digest fingerprint;
    std::string
        unsaidUnits{};  ///< systems that the FE result would fit as well where nobody has said its units; empty: known, or old
    std::vector<Message> placeDoubts{};  ///< placeDoubts() of what was found when its inputs were opened
};

/// Writes a run as it is made (*.run.h5): HDF5, chunked, compressed, single writer with readers (SWMR); every dataset exists before
/// the first frame, so a killed run reopens at its last complete frame. The file stands, and can be opened, once this returns; one
/// that lay there before is replaced then and not earlier. Frames are compressed on a thread of the sink's own and reach other
/// processes a few times a second; destroying the sink writes what is left. Throws WorldError naming file and remedy (disk full, no
/// right to write), from the call that finds it or from the next one; frames committed before stay readable.
std::unique_ptr<TrajectorySink> createRun(const std::string& path, const RunOrigin& origin);

/// Where the checkpoints of a run are kept: beside its file.
std::string checkpointPathOf(const std::string& runPath);

/// As createRun(), but where a checkpoint lies beside it the run that was stopped can go on: its file is set aside
/// (PATH.interrupted) until the run begins anew or has taken over from it what the checkpoint knows of; everything else is dropped.
std::unique_ptr<TrajectorySink> continueRun(const std::string& path, const RunOrigin& origin);

/// A run file opened for reading, complete or still growing, in this or another process.
class RunReader : public TrajectoryReader {
public:
    virtual const std::string& path() const = 0;  ///< as it was opened
    virtual const RunOrigin& origin() const = 0;
    /// Looks for frames that were committed since.
    virtual void refresh() = 0;
    /// Lets go of the file and opens it anew. As long as a reader of the same process holds a file, HDF5 does not write what closes
    /// it: its bytes, and so its digest, change once more when the reader goes. Throws as openRun().
    virtual void reopen() = 0;
    virtual std::vector<LedgerRow> ledger() const = 0;
    /// A row each time that islands of live structure came, as TrajectorySink::addIslands() had it; none in runs of before them.
    virtual std::vector<LedgerRow> islandLedger() const = 0;
    /// A row for each state at which islands lost something; none in runs of before that was known.
    virtual std::vector<IslandLoss> islandLosses() const = 0;
    /// Breaches of health up to the newest frame, in the order in which they began; none in runs that were stopped before such were
    /// written on the way.
    virtual std::vector<HealthBreach> breaches() const = 0;
    /// The solids, components and clusters of the run, so that it can be shown and exported without its FE file; null or empty
    /// until the run has begun.
    virtual std::shared_ptr<const FragmentSet> fragments() const = 0;
    virtual std::shared_ptr<const Clustering> clustering() const = 0;
    virtual std::vector<std::string> componentNames() const = 0;
    virtual std::vector<std::int64_t> elementIds() const = 0;  ///< user's element number of each fragment
    /// The outcome; null while the run is not complete.
    virtual std::shared_ptr<const SimulationResult> result() const = 0;
    virtual std::shared_ptr<const Sizing> sizing() const = 0;
    /// What all stages found, from the components to the simulation (the latter once it is complete).
    virtual Findings findings() const = 0;

    /// Whether the case that it is shown in has other settings by now: its exports say so. Set and read from any thread.
    void setOutgrown(bool outgrown) { m_outgrown = outgrown; }
    /// Whether its file stays: of one that goes with the program no export names the path. Set before it is used.
    void setKept(bool kept) { m_kept = kept; }
    bool kept() const { return m_kept; }
    bool outgrown() const { return m_outgrown; }

private:
    std::atomic<bool> m_outgrown = false;
    bool m_kept = true;
};

/// @param cacheBytes  frames kept in memory at most
/// Throws WorldError, ParseError.
std::shared_ptr<RunReader> openRun(const std::string& path, std::size_t cacheBytes = std::size_t{128} << 20);

/// Checks that the content of a complete run file is what was written: recomputes the digest over all its datasets.
/// Throws ParseError naming the dataset that differs.
void checkRunDigest(const std::string& path, const Execution& execution);

}  // namespace rubble::io
