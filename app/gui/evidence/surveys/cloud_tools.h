#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/session/worker.h"
#include "io/site/clouds/cloud_comparison.h"
#include "widgets/evidence/surveys/cloud_pair_dialog.h"

class QWidget;

namespace rubble {

class Actions;
class Computation;
class Document;
class Session;
namespace widgets {
class ScanDialog;
class ScannerField;
class ViewWidget;
}  // namespace widgets

/// Where scanners stood by a table of points, m, easting, northing and height in the system of the case. Asks for the file; what
/// goes wrong is told. Empty: nothing was chosen.
std::vector<Vec3> scannersOfTable(QWidget* window, Session& session);

/// Lets scanners be clicked in the model as the views show it now, beginning with those that a field has; it takes them as if they
/// had been typed. Nothing where what is typed is no list.
void pickScanners(QWidget* window, Session& session, const widgets::ViewWidget& views, widgets::ScannerField& field);

/// What clouds are made and compared for beside the surveys of a case: a scan of the run, and two clouds held against each other.
class CloudTools : public QObject {
    Q_OBJECT

public:
    CloudTools(Session& session, Actions& actions, const widgets::ViewWidget& views, QWidget& window, QObject* parent = nullptr);

    /// What is said of a name that points cannot be written under.
    static QString wrongEnding();

    void scanRun();
    void compareClouds();
    /// Scans as the dialog says and writes it as LAS, PLY or CSV, by the ending.
    void scanTo(widgets::ScanDialog& dialog, const QString& path);
    void measure(widgets::CloudPairDialog& dialog);
    /// Writes what was measured last; nothing while there is nothing.
    void saveTo(const QString& path);
    void refresh();
    bool busy() const { return m_worker.busy(); }

private:
    std::vector<widgets::CloudPairDialog::Cloud> clouds() const;
    void chooseScanFile(widgets::ScanDialog& dialog);

    Session& m_session;
    Document& m_document;
    Computation& m_computation;
    Actions& m_actions;
    const widgets::ViewWidget& m_views;
    QWidget& m_window;
    std::shared_ptr<const io::CloudComparison> m_made;  ///< of the clouds that the dialog shows; null: none
    // Last, so that it has ended before anything it uses goes.
    Worker m_worker;
};

}  // namespace rubble
