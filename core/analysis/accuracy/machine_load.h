#pragma once

namespace rubble {

/// How much of this machine other programs take: figures of time say nothing of a setting if others worked meanwhile. Counts from
/// its making.
class MachineLoad {
public:
    MachineLoad();
    /// Share of all processors' time since then that went to others, the hypervisor included, in [0, 1]. NaN where the system does
    /// not tell, and within the first tenth of a second, which its clock cannot tell.
    double othersShare() const;

    /// Above this share a figure of time is marked.
    static constexpr double quietBelow = 0.1;

private:
    /// s of processor time; NaN: unknown.
    struct Counters {
        double busy;  ///< of all programs
        double all;   ///< busy or not
        double own;   ///< of this one
    };
    static Counters read();
    Counters m_start;
};

}  // namespace rubble
