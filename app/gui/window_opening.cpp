// What the window opens: a file that is named, the sample, what is dropped on it.
#include <QDragEnterEvent>
#include <QMimeData>
#include <QUrl>

#include "app/gui/evidence_display.h"
#include "app/gui/figure_return.h"
#include "app/gui/file_commands.h"
#include "app/gui/main_window.h"
#include "app/gui/panel_deck.h"
#include "app/gui/sample.h"
#include "app/gui/view_area.h"

namespace rubble {

void MainWindow::open(const QString& path, bool simulate) {
    if (FigureReturn::carriesSource(path)) {
        m_return->begin(path);
        return;
    }
    m_return->forget();
    load(path, simulate);
}

bool MainWindow::load(const QString& path, bool simulate) {
    if (!m_files->mayLeave()) {
        return false;
    }
    m_askedToLeave = true;
    m_simulateWhenReady = simulate;
    m_area->setError({});
    m_deck->clearFailures();
    m_computation.open(path);
    return true;
}

void MainWindow::openSample() {
    const QString path = samplePath();
    if (path.isEmpty()) {
        showFailure({tr("The sample is not installed."), tr("Install Rubble's samples folder, or open a result of your own."),
                     "gui.sample"});
    } else {
        open(path, true);
    }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().front().isLocalFile()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.front().isLocalFile()) {
        event->acceptProposedAction();
        QStringList paths;
        for (const QUrl& url : urls) {
            paths << url.toLocalFile();
        }
        if (!FigureReturn::carriesSource(paths.front()) && m_evidence->takes(paths)) {
            m_evidence->add(paths);
        } else {
            open(paths.front());
        }
    }
}

}  // namespace rubble
