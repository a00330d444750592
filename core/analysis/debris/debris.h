#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/fragments/fragment_set.h"
#include "core/trajectory/trajectory.h"

namespace rubble {

/// Where one fragment lies.
struct DebrisFragment {
    bool present = false;        ///< false: not born yet, or gone (its element came back to life)
    Vec3 centre = Vec3::Zero();  ///< m, centre of mass
    OrientedBox box;             ///< around its solid
    double mass = 0.0;           ///< kg
    double volume = 0.0;         ///< m3 of material
};

/// All fragments of a collapse at one instant, in FragmentId order: clusters are a device of computation and do not appear.
struct Debris {
    double time = 0.0;  ///< s
    std::vector<DebrisFragment> fragments;
};

/// When debris is looked at: at the end of the run, or at the last FE state as in the published method.
enum class DebrisInstant { AtRest, AtFeEnd };

/// The fragments as the bodies of a frame carry them. A fragment that several bodies carried, one after the other, is where the
/// last of them is; it is absent before its birth, after its end, and when its body has left without another in its place.
/// @param carriers  in the order in which they were added
Debris debrisOf(const FragmentSet& fragments, const Components& components, std::span<const Carrier> carriers,
                const TrajectoryFrame& frame);

/// The same at any time of a trajectory (frameAtTime()).
Debris debrisAt(const FragmentSet& fragments, const Components& components, const TrajectoryReader& trajectory, double time);

/// Takes a run and keeps of it only what the debris at rest and at the FE end takes: two frames, whatever the length of the run.
class DebrisRecorder : public TrajectorySink {
public:
    void begin(const RunDescription& description) override;
    void addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) override;
    void commit(const TrajectoryFrame& frame) override;
    void addLedger(const LedgerRow&) override {}
    void finish(const SimulationResult&) override {}
    std::optional<std::string> mark() override;
    bool resume(const RunDescription& description, std::string_view mark) override;

    /// All absent before a frame of that instant was committed. begin() must have been called.
    Debris debris(DebrisInstant instant) const;

private:
    std::shared_ptr<const FragmentSet> m_fragments;
    std::shared_ptr<const Components> m_components;
    std::vector<Carrier> m_carriers;
    double m_feEnd = 0.0;
    TrajectoryFrame m_atFeEnd;
    TrajectoryFrame m_last;
};

}  // namespace rubble
