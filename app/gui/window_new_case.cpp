// The part of the main window that takes cases the wizard makes.
#include <QFileDialog>
#include <QFileInfo>

#include "app/gui/document.h"
#include "app/gui/file_commands.h"
#include "app/gui/inspection.h"
#include "app/gui/main_window.h"
#include "app/gui/new_case.h"
#include "app/gui/panel_deck.h"
#include "app/gui/view_area.h"
#include "widgets/new_case_wizard.h"

namespace rubble {

NewCase* MainWindow::caseInTheMaking() const {
    return m_newCase;
}

void MainWindow::newCase(const QString& path) {
    if (m_newCase != nullptr) {
        m_newCase->wizard().raise();
        m_newCase->wizard().activateWindow();
        return;
    }
    const QString file = path.isEmpty()
                             ? QFileDialog::getOpenFileName(this, tr("FE result of the new case"),
                                                            QFileInfo(m_document.base()).absolutePath(), tr("FE results (*)"))
                             : path;
    if (file.isEmpty()) {
        return;
    }
    m_newCase = new NewCase(file, static_cast<std::size_t>(m_preferences.memoryMib) << 20, m_preferences.keepCopies, *this);
    connect(m_newCase, &NewCase::finished, m_newCase, &QObject::deleteLater);
    connect(m_newCase, &NewCase::created, this, [this](const Opened& opened, const render::View& looks) {
        if (!m_files->mayLeave()) {
            return;
        }
        m_simulateWhenReady = false;
        m_newCase->wizard().accept();
        takeOpened(opened);
        render::View view = m_area->views().view();
        view.componentColours = looks.componentColours;
        view.hiddenComponents = looks.hiddenComponents;
        setView(view);
        m_inspection->refresh();
        m_deck->choose(PanelDeck::Grid);
    });
}

}  // namespace rubble
