#include "widgets/figures/x_display.h"

// Apart from the rest: Xlib's macros take common names.
#include <X11/Xlib.h>

#include <cstdlib>
#include <string>

#include "core/base/error.h"

namespace rubble::figures {

bool displayAvailable() {
    // The connection stays open: a server that resets with its last client would refuse the next one for a moment.
    static Display* held = nullptr;
    static std::string heldName;
    const char* name = std::getenv("DISPLAY");
    if (!name || !*name) {
        return false;
    }
    if (held && heldName == name) {
        return true;
    }
    Display* display = XOpenDisplay(nullptr);
    if (!display) {
        return false;
    }
    if (held) {
        XCloseDisplay(held);
    }
    held = display;
    heldName = name;
    return true;
}

void requireDisplay() {
    if (!displayAvailable()) {
        throw WorldError({"figure.no_display", "No figure can be drawn: there is no X display that answers", {}},
                         {"figure.no_display.remedy",
                          "Set DISPLAY to a running X server, or install xvfb: the command line then starts one itself.",
                          {}});
    }
}

}  // namespace rubble::figures
