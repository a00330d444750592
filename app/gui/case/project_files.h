#pragma once

#include <QObject>
#include <deque>
#include <optional>

#include "app/gui/case/autosave.h"
#include "app/gui/case/recent_cases.h"
#include "app/gui/case/run_history.h"

namespace rubble {

class Session;

/// What is kept for the case beside its file and in the state folder: unsaved changes, the runs, what was opened before, and the
/// work that earlier sessions left behind.
class ProjectFiles : public QObject {
    Q_OBJECT

public:
    explicit ProjectFiles(Session& session);

    Autosave autosave;
    RunHistory runs;
    RecentCases recent;
    bool remembers = false;         ///< what is opened is listed at the next start
    std::deque<LeftWork> left;      ///< what earlier sessions left and nobody has answered for yet
    std::optional<LeftWork> asked;  ///< that is to be recovered
};

}  // namespace rubble
