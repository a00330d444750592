#pragma once

#include <vector>

#include "core/simulation/bodies/hand_over.h"
#include "core/simulation/bodies/run_account.h"

namespace rubble {

/// An error as a share of the scale it is held against, 0 where there is no scale.
inline double relativeError(double error, double scale) {
    return scale > 0.0 ? error / scale : 0.0;
}

/// Holds the FE side, the fragments, the clusters and the bodies against each other at every hand-over.
class Ledger {
public:
    explicit Ledger(const RunDescription& description) : m_description(description) {}

    /// The row of one FE state, of the bodies that have just entered, as the engine holds them before its next step.
    LedgerRow handedOver(std::size_t state, double time, const HandOver& handOver, const RigidWorld& world);
    const LedgerErrors& errors() const { return m_errors; }
    void keep(Archive& archive);

private:
    const RunDescription& m_description;
    LedgerErrors m_errors;
};

}  // namespace rubble
