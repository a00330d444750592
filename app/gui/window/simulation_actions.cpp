#include <QCoreApplication>
#include <array>

#include "app/gui/window/action_table.h"

namespace rubble {

namespace {

using widgets::Glyph;

const std::array simulationTable = {
    ActionRow{"simulate",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "Simulate"),
              QT_TRANSLATE_NOOP("actions", "Simulate the whole collapse as fast as it goes"),
              "Ctrl+R",
              {}},
    ActionRow{"live", "Simulation", QT_TRANSLATE_NOOP("actions", "Live"),
              QT_TRANSLATE_NOOP("actions", "Simulate at the pace of the collapse and watch"), "Ctrl+L", Glyph::Live},
    ActionRow{"cancel", "Simulation", QT_TRANSLATE_NOOP("actions", "Cancel"),
              QT_TRANSLATE_NOOP("actions", "Stop what runs; what is computed is kept"), "Esc", Glyph::Stop},
    ActionRow{"play", "Simulation", QT_TRANSLATE_NOOP("actions", "Play or pause"), QT_TRANSLATE_NOOP("actions", "Play or pause"),
              "Space", Glyph::Play},
    ActionRow{"back", "Simulation", QT_TRANSLATE_NOOP("actions", "Back one state"), QT_TRANSLATE_NOOP("actions", "Back one state"),
              "Left", Glyph::Back},
    ActionRow{"forward", "Simulation", QT_TRANSLATE_NOOP("actions", "Forward one state"),
              QT_TRANSLATE_NOOP("actions", "Forward one state"), "Right", Glyph::Forward},
    ActionRow{"back_ten",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "Back ten states"),
              QT_TRANSLATE_NOOP("actions", "Back ten states"),
              "Shift+Left",
              {}},
    ActionRow{"forward_ten",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "Forward ten states"),
              QT_TRANSLATE_NOOP("actions", "Forward ten states"),
              "Shift+Right",
              {}},
    ActionRow{"first", "Simulation", QT_TRANSLATE_NOOP("actions", "To the first instant"),
              QT_TRANSLATE_NOOP("actions", "To the first instant"), "Home", Glyph::First},
    ActionRow{"last", "Simulation", QT_TRANSLATE_NOOP("actions", "To the last instant"),
              QT_TRANSLATE_NOOP("actions", "To the last instant"), "End", Glyph::Last},
    ActionRow{"play_backwards", "Simulation", QT_TRANSLATE_NOOP("actions", "Play backwards"),
              QT_TRANSLATE_NOOP("actions", "Play backwards or pause"), "Shift+Space", Glyph::PlayBack},
    ActionRow{"loop", "Simulation", QT_TRANSLATE_NOOP("actions", "Loop"),
              QT_TRANSLATE_NOOP("actions", "Playback goes round the range dragged with Shift in the timeline, or round all of it"),
              "Ctrl+Shift+L", Glyph::Loop, true},
    ActionRow{"loop_from",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "Loop from here"),
              QT_TRANSLATE_NOOP("actions", "The range that playback goes round begins at this instant"),
              "[",
              {}},
    ActionRow{"loop_to",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "Loop to here"),
              QT_TRANSLATE_NOOP("actions", "The range that playback goes round ends at this instant"),
              "]",
              {}},
    ActionRow{"bookmark", "Simulation", QT_TRANSLATE_NOOP("actions", "Bookmark…"),
              QT_TRANSLATE_NOOP("actions", "Mark this instant with a note; kept in the case"), "B", Glyph::Bookmark},
    ActionRow{"previous_bookmark",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "To the bookmark before"),
              QT_TRANSLATE_NOOP("actions", "To the bookmark before"),
              ",",
              {}},
    ActionRow{"next_bookmark",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "To the next bookmark"),
              QT_TRANSLATE_NOOP("actions", "To the next bookmark"),
              ".",
              {}},
    ActionRow{
        "snap",
        "Simulation",
        QT_TRANSLATE_NOOP("actions", "Snap to states"),
        QT_TRANSLATE_NOOP("actions", "Scrubbing stops at true states and recorded frames only, so that nothing is interpolated"),
        "",
        {},
        true},
    ActionRow{"time_from_zero",
              "Simulation",
              QT_TRANSLATE_NOOP("actions", "Time from zero"),
              QT_TRANSLATE_NOOP("actions", "Count times from the first state instead of as the FE result has them"),
              "",
              {},
              true},
};

}  // namespace

std::span<const ActionRow> simulationActions() {
    return simulationTable;
}

}  // namespace rubble
