#pragma once

#include <QElapsedTimer>
#include <string>

#include "core/base/execution.h"

namespace rubble {

/// How long a piece of work still takes, from how far it has got since its stage began.
class TimeLeft {
public:
    void restart() { m_stage.clear(); }
    /// Seconds; NaN: not known yet. A stage that begins, or begins again, starts its own clock.
    double after(const Progress& progress);

private:
    QElapsedTimer m_since;
    std::string m_stage;
    double m_first = 0.0;
};

}  // namespace rubble
