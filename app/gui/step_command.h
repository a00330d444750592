#pragma once

#include <QUndoCommand>
#include <functional>
#include <utility>

namespace rubble {

/// A step of work on the case that is no change of settings: its way there and its way back.
class StepCommand : public QUndoCommand {
public:
    using Way = std::function<void()>;
    StepCommand(const QString& what, Way there, Way back)
        : QUndoCommand(what), m_there(std::move(there)), m_back(std::move(back)) {}

    void undo() override { m_back(); }
    void redo() override { m_there(); }

private:
    Way m_there;
    Way m_back;
};

}  // namespace rubble
