#pragma once

namespace rubble {

/// Runs the event loop of the application and returns its exit code. What ends the process from inside the loop, as Qt does on a
/// display that is gone, ends it at once: worker threads still run, and nothing that they use may be destroyed under them.
int runEventLoop();

}  // namespace rubble
