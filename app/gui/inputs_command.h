#pragma once

#include <QUndoCommand>
#include <vector>

#include "app/gui/document.h"

namespace rubble {

/// An edit of the files that a case stands on: the inputs before and after.
class InputsCommand : public QUndoCommand {
public:
    InputsCommand(Document& document, std::vector<CaseInput> after, const QString& what)
        : QUndoCommand(what), m_document(document), m_before(document.theCase().inputs), m_after(std::move(after)) {}

    void undo() override { m_document.putInputs(m_before); }
    void redo() override { m_document.putInputs(m_after); }

private:
    Document& m_document;
    std::vector<CaseInput> m_before;
    std::vector<CaseInput> m_after;
};

}  // namespace rubble
