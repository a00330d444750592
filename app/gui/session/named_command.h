#pragma once

#include <QUndoCommand>
#include <utility>

#include "widgets/basics/wording.h"

namespace rubble {

/// A step of the undo stack that can be named again when another language is spoken.
class NamedCommand : public QUndoCommand {
public:
    explicit NamedCommand(widgets::Wording what) : m_what(std::move(what)) { name(); }

    /// Says in the language of now what the step does.
    void name() { setText(m_what()); }

protected:
    void setWording(widgets::Wording what) {
        m_what = std::move(what);
        name();
    }

private:
    widgets::Wording m_what;
};

}  // namespace rubble
