#pragma once

#include <string_view>

#include "core/base/error.h"
#include "io/jobs/job_record.h"

namespace rubble::io {

/// What went wrong on a cluster in a sentence, and what can be done. The remedy ends with Slurm's own words.
struct SlurmReason {
    Message what;
    Message remedy;
};

/// The reason behind what one of Slurm's programs has written to its error output.
SlurmReason slurmReason(std::string_view words);

/// Why a task is not submitted again. @param task  with a failure
SlurmReason taskReason(const JobTask& task);

}  // namespace rubble::io
