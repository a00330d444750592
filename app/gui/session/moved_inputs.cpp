#include "app/gui/session/moved_inputs.h"

#include <QDir>
#include <QFileInfo>

#include "io/case/case_file.h"

namespace rubble {

std::vector<CaseInput> movedInputs(std::vector<CaseInput> inputs, const QString& from, const QString& to) {
    const QDir folder = QFileInfo(to).absoluteDir();
    for (CaseInput& input : inputs) {
        input.path = folder.relativeFilePath(QString::fromStdString(io::inputPath(from.toStdString(), input))).toStdString();
    }
    return inputs;
}

Case movedCase(const Case& theCase, const QString& from, const QString& to) {
    Case moved = theCase;
    moved.inputs = movedInputs(moved.inputs, from, to);
    return moved;
}

}  // namespace rubble
