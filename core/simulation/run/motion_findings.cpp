#include "core/simulation/run/motion_findings.h"

namespace rubble {

void addMotionFindings(const MotionAccount& account, Findings& findings) {
    if (account.heldTogether > 0) {
        findings.add({"simulation.held_together",
                      "{0} clusters were hit hard enough to break up and were left whole: no room for more bodies",
                      {account.heldTogether}},
                     {"simulation.held_together.remedy", "raise bodies_max, or read the debris there as coarser than it is", {}},
                     "", account.heldTogether);
    }
    if (account.heldBack > 0) {
        findings.add(
            {"simulation.speed_held",
             "{0} times in {1} steps a body was held back: nothing that it touched could have made it that fast",
             {account.heldBack, account.steps}},
            {"simulation.speed_held.remedy",
             "raise step_rate or substeps; light bodies between far heavier ones ask for it. Where as many are held back after "
             "that, what they did is less sure",
             {}},
            "", account.heldBack);
    }
    if (account.moving > 0 && !account.atRest) {
        findings.add({"simulation.still_moving",
                      "{0} of {1} bodies still moved at {2}, when the settle time was over: the debris is not yet what it comes to",
                      {account.moving, account.bodies, {account.end, "s"}}},
                     {"simulation.still_moving.remedy", "raise settle_time", {}}, "", account.moving);
    }
}

}  // namespace rubble
