#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/base/hash.h"
#include "core/fe/activity.h"
#include "core/fe/frame.h"
#include "core/fe/mesh.h"
#include "core/fe/units.h"

namespace rubble {

/// Nodal fields at one state. Positions are absolute (initial + displacement), in the case's local frame.
struct FeState {
    double time = 0.0;             ///< s, on the file's clock
    std::vector<Vec3> positions;   ///< [nodes] m
    std::vector<Vec3> velocities;  ///< [nodes] m/s; empty where the file has none
};

/// Reads states of an FE result one at a time. Implementations are thread-safe and hold no series.
class StateSource {
public:
    virtual ~StateSource() = default;
    /// Reads state k (0-based). Throws ParseError or WorldError naming the file and the state.
    virtual FeState read(std::size_t k) const = 0;
};

/// A finished FE result, ready for the pipeline: mesh, times and activity in memory, nodal fields behind a lazy source
/// with a byte budget. Immutable and shared; all members may be called from several threads.
class FeResult {
public:
    struct Contents {
        std::shared_ptr<const Mesh> mesh;
        std::vector<double> times;  ///< s, strictly increasing [states]
        Activity activity;          ///< as the file says, before any revival policy
        std::vector<double>
            deathTime;  ///< exact death times s on the file's clock, NaN where the file has none [elements or empty]
        bool hasVelocity = false;
        bool looseBodies = false;  ///< each element is a body of a table that is let go, and no structure is left
        std::shared_ptr<const StateSource> source;
        std::string format;                 ///< "Exodus II"
        std::string path;                   ///< as opened; of a series the first file
        std::vector<std::string> files;     ///< all that were read, in their order; several for a series
        bool alone = false;                 ///< opened without other files that differ in a number
        std::uint64_t bytes = 0;            ///< of all files
        std::int64_t written = 0;           ///< ns, when the last of them was written to, by the clock of the file system
        double indexSeconds = 0.0;          ///< wall time it took to read mesh, times and activity
        std::string sha256;                 ///< of the file, hex; of a series, of the list of its files (io::sha256OfFe)
        std::string activityFrom;           ///< how activity was decided, for people: "STATUS, 1 is active"
        std::optional<FileUnits> declared;  ///< what a deck beside the file says that it counts in
        FileUnits units;                    ///< what the file was taken to count in
        Frame frame;                        ///< that everything here has been brought into
        std::string unitsFrom;              ///< how units and up axis were decided, for people
        Digest fingerprint;                 ///< of content and import options
        Findings findings;                  ///< what the reader had to work around
    };

    /// @param byteBudget  bytes of states kept in memory at most (at least two states are always kept)
    explicit FeResult(Contents contents, std::size_t byteBudget = std::size_t{256} << 20);
    ~FeResult();

    const Mesh& mesh() const { return *m_contents.mesh; }
    std::size_t stateCount() const { return m_contents.times.size(); }
    const std::vector<double>& times() const { return m_contents.times; }
    const Activity& activity() const { return m_contents.activity; }
    const Contents& contents() const { return m_contents; }

    /// State k, from memory or from the file. The returned state stays valid as long as it is held.
    std::shared_ptr<const FeState> state(std::size_t k) const;

private:
    struct Cache;
    Contents m_contents;
    std::unique_ptr<Cache> m_cache;
};

}  // namespace rubble
