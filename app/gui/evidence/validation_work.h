#pragma once

#include <QObject>
#include <vector>

#include "app/gui/session/worker.h"
#include "core/pipeline/time_left.h"
#include "core/validation/validation_record.h"

namespace rubble {

/// Holds the program against measured falls in the background, on a worker of its own, and keeps what comes of it in the user's
/// cache as the command line does.
class ValidationWork : public QObject {
    Q_OBJECT

public:
    explicit ValidationWork(QObject* parent = nullptr);

    /// Reads what is kept of this build; answers with changed().
    void load();
    /// Simulates sets that come with the program, one after another; answers with changed(), progressed() and ended().
    /// @param only  their ids; empty: all
    void start(const std::vector<std::string>& only = {});
    void cancel();
    bool running() const { return m_running; }
    const std::vector<ValidationRecord>& records() const { return m_records; }
    const Findings& findings() const { return m_findings; }

signals:
    /// Other records.
    void changed();
    /// @param set          that is being simulated
    /// @param secondsLeft  NaN: not known yet
    void progressed(const QString& set, double fraction, double secondsLeft);
    /// @param failure  null: it came to its end or was cancelled
    void ended(const rubble::Failure* failure);

private:
    void tellSet(const QString& set, std::size_t done, std::size_t count);

    std::vector<ValidationRecord> m_records;
    Findings m_findings;
    bool m_running = false;
    TimeLeft m_left;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
