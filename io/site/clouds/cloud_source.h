#pragma once

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/scenario/cloud_request.h"
#include "io/site/clouds/cloud_head.h"

namespace rubble::io {

/// The points of one file as it holds them, for PointCloud to sift.
class CloudSource {
public:
    virtual ~CloudSource() = default;

    const CloudHead& head() const { return m_head; }
    CloudHead& head() { return m_head; }
    const Findings& findings() const { return m_findings; }
    /// Fills a block with the next points, at most cloudBlockPoints. @return false: there are none left, the block is empty
    /// Throws ParseError, WorldError, Cancelled.
    virtual bool next(CloudBlock& block, const Execution& execution) = 0;

protected:
    CloudHead m_head;
    Findings m_findings;
};

}  // namespace rubble::io
