#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/gui/studies/cluster_work.h"
#include "app/gui/studies/study_work.h"

namespace rubble {

/// An ensemble whose members a cluster makes.
struct ClusterEnsemble {
    StudyCase of;
    StudyOrder order;
    JobCase read;  ///< by the tasks
    std::vector<std::string> sbatchOptions;
    bool submits = true;  ///< false: only what was submitted earlier is gone on with
    /// Takes the members as they come. Runs on the worker's thread.
    std::function<void(const MadeEnsemble& made)> take;
};

ClusterWork::Study clusterStudy(ClusterEnsemble ensemble);

}  // namespace rubble
