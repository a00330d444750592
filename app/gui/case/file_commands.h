#pragma once

#include <QObject>
#include <exception>
#include <functional>
#include <memory>
#include <ostream>

#include "core/scenario/case.h"
#include "widgets/basics/wording.h"
#include "widgets/render/basics/scene_data.h"
#include "widgets/render/basics/view.h"
#include "widgets/views/history_chart.h"

class QWidget;

namespace rubble {

class Actions;
class Computation;
class Execution;
struct AccuracyReport;
struct Calibration;
class Document;
class Session;
namespace io {
class RunReader;
}

/// Saving and exporting: asks for paths, writes on the worker, says what came of it.
class FileCommands : public QObject {
    Q_OBJECT

public:
    FileCommands(Session& session, Actions& actions, QWidget& window);

    /// Asks whether a changed case should be saved; false: the user wants to stay.
    bool mayLeave();
    QString askForInput();
    /// Asks for a raster of heights and makes it the terrain of the case.
    void chooseTerrain();
    /// The case goes on without a terrain.
    void dropTerrain();
    /// Asks for an orthophoto, or for meshes of the surroundings, and takes them into the case.
    void chooseOrthophoto();
    void chooseSurroundings();
    /// The case goes on without both.
    void dropSurroundings();
    /// Asks how the case lies in the world.
    void editSite();
    bool save();
    bool saveAs();
    /// Writes the case to a path; says what went wrong in a message through failed().
    bool saveTo(const QString& path);
    void saveRun();
    void saveRunTo(const QString& path);
    void exportFragments();
    /// Only these fragments.
    void exportSelection(const std::vector<FragmentId>& fragments);
    void exportSelectionTo(const QString& path, const std::vector<FragmentId>& fragments);
    void exportView(const render::View& view);
    /// A view that the user chooses; nothing if he does not, or if it cannot be read.
    std::optional<render::View> importView();
    void exportSeries();
    void exportVtkHdf();
    void exportGltf();
    void saveSweep(const std::shared_ptr<const AccuracyReport>& report);
    void saveCalibration(const std::shared_ptr<const Calibration>& calibration);
    void saveHistory(const widgets::HistoryChart::Content& history);
    /// Writes the settings compared as CSV, with the columns of rubble-cli accuracy --csv.
    void saveSweepTo(const QString& path, const AccuracyReport& report);
    /// Writes the points of a calibration as CSV, with the columns of rubble-cli calibrate --csv.
    void saveCalibrationTo(const QString& path, const Calibration& calibration);
    void saveHistoryTo(const QString& path, const widgets::HistoryChart::Content& history);

private:
    bool mayLeaveRun();
    bool copyRunTo(const QString& path);
    void connectActions(Actions& actions);
    void setTerrain(const QString& path, const widgets::Wording& what);
    /// The case with files of a role put in place of those it has, or beside them.
    void setFiles(InputRole role, const QStringList& paths, bool beside, const widgets::Wording& what);
    QString askForOutput(const QString& title, const QString& suffix, const QString& filter);
    using RunExport = std::function<void(const std::string& path, const io::RunReader& run, const Execution& execution)>;
    /// Asks for a path and writes the run that is shown there; nothing while it is not finished.
    void exportRun(const QString& title, const QString& suffix, const QString& filter, const RunExport& write);
    void writeRun(const QString& path, const std::shared_ptr<io::RunReader>& run, const RunExport& write);
    void writeTable(const QString& path, const std::function<void(std::ostream&)>& table);

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    QWidget& m_window;
};

}  // namespace rubble
