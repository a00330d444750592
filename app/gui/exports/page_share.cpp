
#include "app/gui/exports/picture_export.h"
#include "app/gui/exports/run_orders.h"
#include "app/gui/session/save_path.h"
#include "app/gui/session/session.h"

namespace rubble {

void PictureExport::sharePage(const render::SceneData& data) {
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr || record->reader == nullptr || record->running) {
        return;
    }
    const render::SceneData shown = data;
    const QString path = askSavePath(&m_window, tr("Page"), proposed(QStringLiteral(".html")), tr("Pages (*.html)"));
    if (path.isEmpty()) {
        return;
    }
    sharePageAt(path, shown);
}

void PictureExport::sharePageAt(const QString& path, const render::SceneData& data) {
    const RunRecord* record = m_computation.currentRun();
    if (record == nullptr || record->reader == nullptr || record->running) {
        return;
    }
    const auto order = std::make_shared<const PageOrder>(
        PageOrder{path.toStdString(), record->reader, m_computation.inputs(), m_document.theCase(), m_document.path().toStdString(),
                  m_document.base().toStdString(), data, madeNow(data).around, io::openingFindings(m_computation.content())});
    m_computation.write([order](const Execution& execution) { order->write(execution); },
                        [session = &m_session, path](const std::exception_ptr& thrown) { session->tellWritten(path, thrown); });
}

}  // namespace rubble
