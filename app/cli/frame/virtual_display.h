#pragma once

#include <sys/types.h>

namespace rubble::cli {

/// An X server without a screen, for figures where no display answers: starts Xvfb as a child on a free display number and points
/// DISPLAY at it; ends it when it dies. Does nothing if a display answers already. Everything that talks to
/// the display must be gone before this is.
class VirtualDisplay {
public:
    /// Throws WorldError (remedy: install xvfb) if the server does not start.
    VirtualDisplay();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

private:
    void end();

    pid_t m_server = 0;
};

}  // namespace rubble::cli
