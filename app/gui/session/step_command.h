#pragma once

#include <functional>
#include <utility>

#include "app/gui/session/named_command.h"

namespace rubble {

/// A step of work on the case that is no change of settings: its way there and its way back.
class StepCommand : public NamedCommand {
public:
    using Way = std::function<void()>;
    StepCommand(widgets::Wording what, Way there, Way back)
        : NamedCommand(std::move(what)), m_there(std::move(there)), m_back(std::move(back)) {}

    void undo() override { m_back(); }
    void redo() override { m_there(); }

private:
    Way m_there;
    Way m_back;
};

}  // namespace rubble
