#include "widgets/figures/x_display.h"

// Apart from the rest: Xlib's macros take common names.
#include <X11/Xlib.h>

#include <cstdlib>

namespace rubble::figures {

bool displayAvailable() {
    const char* name = std::getenv("DISPLAY");
    if (!name || !*name) {
        return false;
    }
    Display* display = XOpenDisplay(nullptr);
    if (!display) {
        return false;
    }
    XCloseDisplay(display);
    return true;
}

}  // namespace rubble::figures
