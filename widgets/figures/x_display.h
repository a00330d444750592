#pragma once

namespace rubble::figures {

/// True if an off-screen GL window can be opened: DISPLAY names an X server that answers. VTK ends the process otherwise.
bool displayAvailable();

/// Throws WorldError (remedy: an X display, or Xvfb) unless displayAvailable().
void requireDisplay();

}  // namespace rubble::figures
