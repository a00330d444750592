#include "app/gui/window/event_loop.h"

#include <QApplication>
#include <atomic>
#include <cstdlib>

namespace rubble {

namespace {

std::atomic<bool> loopRuns{false};

void endAtOnce() {
    if (loopRuns) {
        std::_Exit(EXIT_FAILURE);
    }
}

}  // namespace

int runEventLoop() {
    // Registered late, so that it is called before statics are destroyed.
    std::atexit(endAtOnce);
    loopRuns = true;
    const int code = QApplication::exec();
    loopRuns = false;
    return code;
}

}  // namespace rubble
