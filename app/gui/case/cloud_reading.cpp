#include "app/gui/case/cloud_reading.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

#include "app/gui/session/worker.h"
#include "io/case/case_surveys.h"
#include "widgets/evidence/surveys/reading_box.h"

namespace rubble {

namespace {

/// Texts of this file.
struct CloudReading {
    Q_DECLARE_TR_FUNCTIONS(rubble::CloudReading)
};

}  // namespace

QString tryCloudReading(CaseInput& input, const std::string& path, const CloudRequest& read) {
    try {
        io::stateReading(input, path, read);
    } catch (...) {
        return failureOf(std::current_exception())->inOneLine();
    }
    return {};
}

bool askCloudReading(QWidget* window, CaseInput& input, const QString& path, const Frame& frame) {
    const io::OpenReading open = io::readingLeftOpen(input, path.toStdString(), frame);
    if (!open.any() || !input.read.empty()) {
        return true;
    }
    QStringList words;
    if (open.columns) {
        words << CloudReading::tr(
            "No heading names the columns of this table. Left empty, the first three are taken as x, y and z where all rows hold "
            "numbers.");
    }
    if (open.system) {
        words << CloudReading::tr(
            "The file names no coordinate system. Left empty, its coordinates are taken to be those of the case.");
    }
    widgets::ReadingDialog dialog(QFileInfo(path).fileName(), words, input.read, window);
    dialog.setTrial(
        [&](const CloudRequest& said) { return said.empty() ? QString() : tryCloudReading(input, path.toStdString(), said); });
    return dialog.exec() == QDialog::Accepted;
}

}  // namespace rubble
