#pragma once

#include <QObject>
#include <memory>

#include "app/gui/session/worker.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/time_left.h"
#include "io/run/run_file.h"

namespace rubble {

/// The reference of a scene (each fragment its own body) as a run that a view can be compared with at every time. It lies in the
/// user's cache, under the key of what it was simulated from, so that it is computed once.
class ReferenceWork : public QObject {
    Q_OBJECT

public:
    explicit ReferenceWork(QObject* parent = nullptr);

    /// Opens what is kept for a scenario; answers with changed(). Another scene's reference is let go.
    void look(const Inputs& inputs, const Scenario& scenario);
    /// Simulates it; answers with progressed() and ended().
    /// @param origin  of the run whose reference it is: its files
    void start(const Inputs& inputs, const Scenario& scenario, io::RunOrigin origin);
    void cancel();
    void clear();
    bool running() const { return m_running; }
    /// Tells once more how far it has got.
    void tellProgress() { m_worker.tellProgress(); }
    /// Null: there is none for the scenario that was looked for.
    const std::shared_ptr<io::RunReader>& reader() const { return m_reader; }
    /// Where the reference of a scenario lies. Throws WorldError where there is no folder for what can be made again.
    static QString pathOf(const Digest& key);

signals:
    void changed();
    /// @param secondsLeft  NaN: not known yet
    void progressed(double fraction, double secondsLeft);
    /// @param failure  null: it came to its end or was cancelled
    void ended(const rubble::Failure* failure);

private:
    std::shared_ptr<io::RunReader> m_reader;
    Digest m_key;  // of the scene that was looked for
    bool m_running = false;
    bool m_looking = false;  // the kept files are being looked through
    TimeLeft m_left;
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

/// The scenario of the reference that views are compared with, and its key.
Scenario comparedReference(const Scenario& scenario);

}  // namespace rubble
