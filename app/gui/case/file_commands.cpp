#include "app/gui/case/file_commands.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "app/gui/case/cloud_reading.h"
#include "app/gui/case/project_files.h"
#include "app/gui/session/file_kinds.h"
#include "app/gui/session/moved_inputs.h"
#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/actions.h"
#include "core/analysis/accuracy/calibration_table.h"
#include "core/analysis/accuracy/sweep_table.h"
#include "core/base/error.h"
#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/exports.h"
#include "io/exports/provenance.h"
#include "io/run/acknowledgements.h"
#include "io/site/place_check.h"
#include "widgets/case/site_dialog.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/view_json.h"

namespace rubble {

namespace {

/// A table of these fragments alone.
auto tableOf(const std::vector<FragmentId>& fragments) {
    return [fragments](const std::string& path, const io::RunReader& run, const Execution& execution) {
        io::exportFragments(path, run, fragments, execution);
    };
}

/// What was said about a run goes with it; what lies beside the target is about the run that lay there before.
void copyAcknowledgements(const std::string& fromRun, const std::string& toRun) {
    const std::filesystem::path from = io::acknowledgementPath(fromRun);
    const std::filesystem::path to = io::acknowledgementPath(toRun);
    std::error_code failed;
    std::filesystem::remove(to, failed);
    if (!failed && std::filesystem::exists(from, failed)) {
        std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing, failed);
    }
    if (failed) {
        throw WorldError({"gui.save_acknowledgement", "{0} cannot be written: {1}", {to.string(), failed.message()}},
                         {"gui.save_acknowledgement.remedy", "Choose another folder, or make room there.", {}});
    }
}

/// Copies a run file with what was said about it.
void copyRun(const std::string& from, const std::string& to, const Execution& execution) {
    io::writeAtomically(to, [&](std::ostream& out) {
        std::ifstream in(from, std::ios::binary);
        std::vector<char> block(1 << 20);
        while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
            execution.check();
            out.write(block.data(), in.gcount());
        }
    });
    copyAcknowledgements(from, to);
}

}  // namespace

FileCommands::FileCommands(Session& session, Actions& actions, QWidget& window)
    : m_session(session), m_document(session.document()), m_computation(session.computation()), m_window(window) {
    connectActions(actions);
}

void FileCommands::connectActions(Actions& actions) {
    const auto on = [&](ActionId id, auto slot) { connect(&actions[id], &QAction::triggered, this, slot); };
    on(ActionId::Terrain, &FileCommands::chooseTerrain);
    on(ActionId::NoTerrain, &FileCommands::dropTerrain);
    on(ActionId::Orthophoto, &FileCommands::chooseOrthophoto);
    on(ActionId::Surroundings, &FileCommands::chooseSurroundings);
    on(ActionId::NoSurroundings, &FileCommands::dropSurroundings);
    on(ActionId::Site, &FileCommands::editSite);
    on(ActionId::Save, &FileCommands::save);
    on(ActionId::SaveAs, &FileCommands::saveAs);
    on(ActionId::SaveRun, &FileCommands::saveRun);
    on(ActionId::ExportFragments, &FileCommands::exportFragments);
    on(ActionId::ExportSeries, &FileCommands::exportSeries);
    on(ActionId::ExportVtkhdf, &FileCommands::exportVtkHdf);
    on(ActionId::ExportGltf, &FileCommands::exportGltf);
}

QString FileCommands::askForInput() {
    return QFileDialog::getOpenFileName(&m_window, tr("Open"), QFileInfo(m_document.base()).absolutePath(),
                                        tr("Cases, FE results, runs and figures of them (*);;Cases (*.rubble);;Runs (*.run.h5)"));
}

void FileCommands::setTerrain(const QString& path, const widgets::Wording& what) {
    std::vector<CaseInput> inputs;
    for (const CaseInput& input : m_document.theCase().inputs) {
        if (input.role != InputRole::Terrain) {
            inputs.push_back(input);
        }
    }
    if (!path.isEmpty()) {
        const QDir folder = QFileInfo(m_document.base()).absoluteDir();
        inputs.push_back({"terrain-1", InputRole::Terrain, folder.relativeFilePath(path).toStdString(), ""});
        if (!askCloudReading(&m_window, inputs.back(), path, m_document.theCase().frame)) {
            return;
        }
    }
    m_document.setInputs(std::move(inputs), what);
}

void FileCommands::chooseTerrain() {
    const QString path =
        QFileDialog::getOpenFileName(&m_window, tr("Terrain"), QFileInfo(m_document.base()).absolutePath(), terrainFileKinds());
    if (!path.isEmpty()) {
        setTerrain(path, [name = QFileInfo(path).fileName()] { return tr("terrain %1").arg(name); });
    }
}

void FileCommands::dropTerrain() {
    setTerrain({}, [] { return tr("terrain left out"); });
}

void FileCommands::setFiles(InputRole role, const QStringList& paths, bool beside, const widgets::Wording& what) {
    std::vector<CaseInput> inputs = m_document.theCase().inputs;
    if (!beside) {
        std::erase_if(inputs, [&](const CaseInput& input) { return input.role == role; });
    }
    const QDir folder = QFileInfo(m_document.base()).absoluteDir();
    const std::string stem = role == InputRole::Orthophoto ? "orthophoto-" : "surroundings-";
    for (const QString& path : paths) {
        int number = 1;
        const auto taken = [&] {
            return std::any_of(inputs.begin(), inputs.end(),
                               [&](const CaseInput& input) { return input.id == stem + std::to_string(number); });
        };
        while (taken()) {
            ++number;
        }
        inputs.push_back({stem + std::to_string(number), role, folder.relativeFilePath(path).toStdString(), ""});
        if (role == InputRole::Surroundings && !askCloudReading(&m_window, inputs.back(), path, m_document.theCase().frame)) {
            return;
        }
    }
    m_document.setInputs(std::move(inputs), what);
}

void FileCommands::chooseOrthophoto() {
    const QString path =
        QFileDialog::getOpenFileName(&m_window, tr("Orthophoto"), QFileInfo(m_document.base()).absolutePath(),
                                     tr("Pictures of the ground (*.tif *.tiff *.jp2 *.jpg *.jpeg *.png *.img);;All files (*)"));
    if (!path.isEmpty()) {
        setFiles(InputRole::Orthophoto, {path}, false,
                 [name = QFileInfo(path).fileName()] { return tr("orthophoto %1").arg(name); });
    }
}

void FileCommands::chooseSurroundings() {
    const QStringList paths = QFileDialog::getOpenFileNames(
        &m_window, tr("Surroundings"), QFileInfo(m_document.base()).absolutePath(),
        tr("Meshes and point clouds (*.obj *.ply *.stl *.gltf *.glb *.las *.laz *.e57 *.pcd *.ptx *.pts);;All "
           "files (*)"));
    if (!paths.isEmpty()) {
        setFiles(InputRole::Surroundings, paths, true,
                 [name = QFileInfo(paths.front()).fileName()] { return tr("surroundings %1").arg(name); });
    }
}

void FileCommands::dropSurroundings() {
    std::vector<CaseInput> inputs = m_document.theCase().inputs;
    std::erase_if(inputs, [](const CaseInput& input) {
        return input.role == InputRole::Orthophoto || input.role == InputRole::Surroundings;
    });
    m_document.setInputs(std::move(inputs), [] { return tr("orthophoto and surroundings left out"); });
}

void FileCommands::editSite() {
    const Case& theCase = m_document.theCase();
    widgets::SiteDialog dialog(&m_window);
    std::vector<widgets::SiteMeshOffset> meshes;
    for (const CaseInput& input : theCase.inputs) {
        if (input.role == InputRole::Surroundings) {
            meshes.push_back({QFileInfo(QString::fromStdString(input.path)).fileName(), input.offset});
        }
    }
    dialog.setContent(theCase.site, QString::fromStdString(theCase.frame.crs), meshes);
    dialog.setTerrain(m_computation.terrain().findings);
    const Frame frame = m_computation.inputs().fe != nullptr ? m_computation.inputs().frame : theCase.frame;
    dialog.setCheck([frame](const Site& site, const std::string& crs) {
        Frame placed = frame;
        placed.crs = crs;
        return io::checkPlace(placed, site);
    });
    if (dialog.exec() == QDialog::Accepted) {
        std::vector<std::optional<Vec3>> offsets;
        for (const widgets::SiteMeshOffset& mesh : dialog.surroundings()) {
            offsets.push_back(mesh.offset);
        }
        m_document.setSite(dialog.site(), dialog.crs().toStdString(), offsets, [] { return tr("site"); });
    }
}

// Kept runs stay; one for which there was no room or no right to keep it is asked about.
bool FileCommands::mayLeaveRun() {
    const RunRecord* record = m_computation.currentRun();
    if (record != nullptr && record->running && record->kept) {
        QMessageBox question(QMessageBox::Question, tr("Stop the simulation?"),
                             tr("A simulation is running. Leaving ends it here; what it has so far stays in the list of runs."),
                             QMessageBox::Discard | QMessageBox::Cancel, &m_window);
        question.button(QMessageBox::Discard)->setText(tr("Stop and leave"));
        question.setDefaultButton(QMessageBox::Cancel);
        return question.exec() == QMessageBox::Discard;
    }
    if (record == nullptr || record->kept || record->reader == nullptr || record->reader->frameCount() == 0) {
        return true;
    }
    QMessageBox question(QMessageBox::Question, tr("Save the run?"), tr("The run of this case is kept nowhere and goes with it."),
                         QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    if (!record->running) {
        question.addButton(QMessageBox::Save);
        question.setDefaultButton(QMessageBox::Save);
    }
    const int answer = question.exec();
    if (answer != QMessageBox::Save) {
        return answer == QMessageBox::Discard;
    }
    const QString path = askForOutput(tr("Save run"), QStringLiteral(".run.h5"), tr("Runs (*.run.h5)"));
    return !path.isEmpty() && copyRunTo(path);
}

bool FileCommands::copyRunTo(const QString& path) {
    try {
        copyRun(m_computation.currentRun()->path.toStdString(), path.toStdString(), Execution());
        m_session.part<ProjectFiles>().runs.keptAt(QFileInfo(path).absoluteFilePath());
        return true;
    } catch (...) {
        m_session.report(*failureOf(std::current_exception()));
        return false;
    }
}

bool FileCommands::mayLeave() {
    if (!mayLeaveRun()) {
        return false;
    }
    if (!m_document.modified()) {
        return true;
    }
    const auto answer = QMessageBox::question(
        &m_window, tr("Save the case?"),
        (m_document.path().isEmpty() ? tr("The case of %1 was never saved: its settings and its evidence would go.")
                                     : tr("%1 has changed since it was saved: its settings or its evidence would go."))
            .arg(QFileInfo(m_document.path().isEmpty() ? m_document.base() : m_document.path()).fileName()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

QString FileCommands::askForOutput(const QString& title, const QString& suffix, const QString& filter) {
    const QFileInfo base(m_document.base());
    QString stem = base.fileName();
    stem = stem.left(stem.indexOf(u'.') > 0 ? stem.indexOf(u'.') : stem.size());
    return askSavePath(&m_window, title, base.absolutePath() + u'/' + stem + suffix, filter);
}

bool FileCommands::save() {
    return m_document.path().isEmpty() || m_document.readOnly() ? saveAs() : saveTo(m_document.path());
}

bool FileCommands::saveAs() {
    const QString path = askForOutput(tr("Save case"), QStringLiteral(".rubble"), tr("Cases (*.rubble)"));
    return !path.isEmpty() && saveTo(path);
}

bool FileCommands::saveTo(const QString& path) {
    return m_session.writeNow(path, [&] {
        if (Document::isReadOnly(path)) {
            throw WorldError({"gui.read_only", "{0} is to be read only", {path.toStdString()}},
                             {"gui.read_only.remedy", "Save the case under another name.", {}});
        }
        Case moved = movedCase(m_document.theCase(), m_document.base(), path);
        for (CaseInput& input : moved.inputs) {
            if (m_computation.inputs().fe != nullptr && input.role == InputRole::Fe && input.sha256.empty()) {
                input.sha256 = m_computation.inputs().fe->contents().sha256;
            }
            if (input.role == InputRole::Terrain && input.sha256.empty()) {
                input.sha256 = m_computation.terrain().sha256;
            }
            for (const io::SiteFile& file : m_computation.terrain().files) {
                if (input.sha256.empty() && file.input == input.id) {
                    input.sha256 = file.sha256;
                }
            }
        }
        m_document.saved(io::saveCase(path.toStdString(), moved), path);
    });
}

void FileCommands::saveRun() {
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr || record->running) {
        return;
    }
    const QString path = askForOutput(tr("Save run"), QStringLiteral(".run.h5"), tr("Runs (*.run.h5)"));
    if (!path.isEmpty()) {
        saveRunTo(path);
    }
}

void FileCommands::saveRunTo(const QString& path) {
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr || record->running) {
        return;
    }
    m_computation.write(
        [from = record->path.toStdString(), to = path.toStdString()](const Execution& execution) {
            execution.report({"gui.saving_run", "Saving the run", {}}, 0.0);
            copyRun(from, to, execution);
        },
        [session = &m_session, path, kept = record->path](const std::exception_ptr& thrown) {
            session->tellWritten(path, thrown);
            const RunRecord* shown = session->computation().currentRun();
            if (thrown == nullptr && shown != nullptr && shown->path == kept) {
                session->part<ProjectFiles>().runs.keptAt(QFileInfo(path).absoluteFilePath());
            }
        });
}

void FileCommands::exportFragments() {
    exportRun(tr("Table of fragments"), QStringLiteral(".csv"), tr("Tables (*.csv)"),
              [](const std::string& path, const io::RunReader& run, const Execution& execution) {
                  io::exportFragments(path, run, execution);
              });
}

void FileCommands::exportSelection(const std::vector<FragmentId>& fragments) {
    if (!fragments.empty()) {
        exportRun(tr("Table of selected fragments"), QStringLiteral("-selection.csv"), tr("Tables (*.csv)"), tableOf(fragments));
    }
}

void FileCommands::exportSelectionTo(const QString& path, const std::vector<FragmentId>& fragments) {
    writeRun(path, m_computation.currentRun()->reader, tableOf(fragments));
}

void FileCommands::exportView(const render::View& view) {
    const QString path = askForOutput(tr("View"), QStringLiteral("-view.json"), tr("Views (*.json)"));
    if (!path.isEmpty()) {
        writeTable(path, [&](std::ostream& out) { out << figures::toJson(view); });
    }
}

std::optional<render::View> FileCommands::importView() {
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open a view"), QFileInfo(m_document.base()).absolutePath(),
                                                      tr("Views (*.json);;All files (*)"));
    if (path.isEmpty()) {
        return std::nullopt;
    }
    try {
        return figures::viewFromFile(path.toStdString());
    } catch (...) {
        const auto failure = failureOf(std::current_exception());
        m_session.report(*failure);
        return std::nullopt;
    }
}

void FileCommands::exportSeries() {
    exportRun(tr("Series for ParaView"), QStringLiteral(".pvd"), tr("Series (*.pvd)"),
              [fe = m_computation.inputs().fe](const std::string& path, const io::RunReader& run, const Execution& execution) {
                  io::exportSeries(path, run, *fe, execution);
              });
}

void FileCommands::exportVtkHdf() {
    exportRun(tr("Series in one file"), QStringLiteral(".vtkhdf"), tr("VTKHDF (*.vtkhdf)"),
              [fe = m_computation.inputs().fe](const std::string& path, const io::RunReader& run, const Execution& execution) {
                  io::exportVtkHdf(path, run, *fe, execution);
              });
}

void FileCommands::exportGltf() {
    exportRun(tr("Fragments as glTF"), QStringLiteral(".glb"), tr("Binary glTF (*.glb)"),
              [fe = m_computation.inputs().fe](const std::string& path, const io::RunReader& run, const Execution& execution) {
                  io::exportGltf(path, run, fe.get(), execution);
              });
}

void FileCommands::exportRun(const QString& title, const QString& suffix, const QString& filter, const RunExport& write) {
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr || record->reader == nullptr || record->running) {
        return;
    }
    // What was shown when it was asked for: another run may have taken its place before the answer.
    const std::shared_ptr<io::RunReader> run = record->reader;
    const QString path = askForOutput(title, suffix, filter);
    if (!path.isEmpty()) {
        writeRun(path, run, write);
    }
}

void FileCommands::writeRun(const QString& path, const std::shared_ptr<io::RunReader>& run, const RunExport& write) {
    m_computation.write([path, run, write](const Execution& execution) { write(path.toStdString(), *run, execution); },
                        [session = &m_session, path](const std::exception_ptr& thrown) { session->tellWritten(path, thrown); });
}

void FileCommands::saveSweep(const std::shared_ptr<const AccuracyReport>& report) {
    if (report == nullptr) {
        return;
    }
    const QString path = askForOutput(tr("Settings compared"), QStringLiteral("-accuracy.csv"), tr("Tables (*.csv)"));
    if (!path.isEmpty()) {
        saveSweepTo(path, *report);
    }
}

void FileCommands::saveCalibration(const std::shared_ptr<const Calibration>& calibration) {
    if (calibration == nullptr) {
        return;
    }
    const QString path = askForOutput(tr("Calibration"), QStringLiteral("-calibration.csv"), tr("Tables (*.csv)"));
    if (!path.isEmpty()) {
        saveCalibrationTo(path, *calibration);
    }
}

void FileCommands::saveSweepTo(const QString& path, const AccuracyReport& report) {
    writeTable(path, [&](std::ostream& out) { writeSweepCsv(report, out); });
}

void FileCommands::saveCalibrationTo(const QString& path, const Calibration& calibration) {
    writeTable(path, [&](std::ostream& out) { writeCalibrationCsv(calibration, out); });
}

void FileCommands::writeTable(const QString& path, const std::function<void(std::ostream&)>& table) {
    m_session.writeNow(path, [&] { io::writeAtomically(path.toStdString(), table); });
}

void FileCommands::saveHistory(const widgets::HistoryChart::Content& history) {
    const QString path = askForOutput(tr("History curves"), QStringLiteral("-history.csv"), tr("Tables (*.csv)"));
    if (!path.isEmpty()) {
        saveHistoryTo(path, history);
    }
}

void FileCommands::saveHistoryTo(const QString& path, const widgets::HistoryChart::Content& history) {
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr || record->reader == nullptr || history.points.empty()) {
        return;
    }
    const std::string subject = "History of " + history.subject.toStdString();
    const io::ExportRecord exported{"table",
                                    {{subject, history.points.front().time, history.points.back().time, "simulated"}},
                                    {},
                                    {},
                                    m_document.path().toStdString()};
    m_session.writeNow(path, [&] {
        io::writeAtomically(path.toStdString(), [&](std::ostream& out) { writeHistoryCsv(history.points, out); });
        io::writeProvenance(path.toStdString(), io::exportProvenance(exported, record->reader->origin(), record->reader.get()));
    });
}

}  // namespace rubble
