#pragma once

namespace rubble::cli {

/// An X server without a screen, for figures where no display answers: starts Xvfb as a child on a free display number and points
/// DISPLAY at it. Does nothing if a display answers already. The server stays until the program ends: libraries keep connections,
/// and end the program where one breaks.
class VirtualDisplay {
public:
    /// Throws WorldError (remedy: install xvfb) if the server does not start.
    VirtualDisplay();
};

}  // namespace rubble::cli
