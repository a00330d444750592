#include "app/gui/window/screenshot.h"

#include <QApplication>
#include <QPainter>
#include <QPixmap>
#include <cstdio>

#include "app/gui/accuracy/accuracy_display.h"
#include "app/gui/case/file_commands.h"
#include "app/gui/case/new_case.h"
#include "app/gui/evidence/causes_display.h"
#include "app/gui/evidence/cloud_points.h"
#include "app/gui/evidence/evidence_display.h"
#include "app/gui/evidence/evidence_studies.h"
#include "app/gui/evidence/photograph_places.h"
#include "app/gui/evidence/survey_display.h"
#include "app/gui/evidence/survey_reach.h"
#include "app/gui/session/session.h"
#include "app/gui/stage/panel_deck.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/window/main_window.h"
#include "widgets/accuracy/accuracy_chart.h"
#include "widgets/accuracy/accuracy_page.h"
#include "widgets/evidence/evidence_page.h"
#include "widgets/figures/figure_file.h"
#include "widgets/figures/view_json.h"

namespace rubble {

Screenshot::Screenshot(MainWindow& window, const Options& options) : QObject(&window), m_window(window), m_options(options) {
    m_timer.setInterval(100);
    connect(&m_timer, &QTimer::timeout, this, &Screenshot::look);
    m_timer.start();
    m_dialogs.setInterval(100);
    connect(&m_dialogs, &QTimer::timeout, this, &Screenshot::watchDialogs);
    // Where nothing could be read, what was open stays: there is nothing to take a picture of.
    connect(&window.session().computation(), &Computation::opened, this, [this](const Opened& opened) {
        if (opened.fe == nullptr && opened.failure) {
            giveUp(*opened.failure);
        }
    });
}

void Screenshot::watchDialogs() {
    // A dialog holds up the action that opened it, so nothing else would ever take the picture.
    constexpr int looks = 15;  // 1.5 s: what it previews is drawn by then
    m_dialogSeen = QApplication::activeModalWidget() != nullptr ? m_dialogSeen + 1 : 0;
    if (m_dialogSeen == looks) {
        m_dialogs.stop();
        take();
    }
}

void Screenshot::look() {
    Computation& computation = m_window.session().computation();
    if (computation.failure() && !computation.busy()) {
        giveUp(*computation.failure());
        return;
    }
    const NewCase* making = m_window.rooms().opening->caseInTheMaking();
    if (making != nullptr && !making->settled()) {
        return;
    }
    const bool nothing = (m_options.path.isEmpty() && !m_options.sample) || making != nullptr;
    const bool prepared = nothing || computation.results().clustering != nullptr;
    const RunRecord* record = computation.currentRun();
    const bool simulated = record != nullptr && record->outcome != nullptr;
    const bool comparing = m_window.rooms().accuracy->waiting() || m_window.rooms().accuracy->work().running();
    if (computation.busy() || comparing || !prepared || (!nothing && (m_options.simulate || m_options.sample) && !simulated)) {
        return;
    }
    try {
        if (!m_prepared) {
            prepare();
        }
    } catch (...) {
        giveUp(*failureOf(std::current_exception()));
        return;
    }
    if (m_taken) {
        return;
    }
    // What the photographs show, islands and studies are made in the background.
    if (!m_window.rooms().evidence->settled() || m_window.rooms().islands->busy() || m_window.rooms().survey->busy() ||
        m_window.session().part<SurveyReach>().busy() || m_window.session().part<PhotographPlaces>().busy() ||
        m_window.rooms().cloudPoints->busy() || m_window.rooms().cloudTools->busy() || m_window.rooms().studies->work().running()) {
        return;
    }
    m_timer.stop();
    // The views draw once more before the picture is taken.
    QTimer::singleShot(1000, this, &Screenshot::take);
}

void Screenshot::giveUp(const Failure& failure) {
    m_timer.stop();
    std::fprintf(stderr, "rubble: %s %s\n", qPrintable(failure.what()), qPrintable(failure.remedy()));
    QCoreApplication::exit(1);
}

void Screenshot::prepare() {
    m_prepared = true;
    m_window.rooms().playback->clock().pause();
    if (m_options.panel) {
        m_window.rooms().deck->choosePage(*m_options.panel);
    }
    m_window.rooms().studies->causes().addCauses(m_options.causes);
    m_window.rooms().studies->causes().addEvidence(m_options.against);
    const auto scrub = [this](double time) { m_window.rooms().playback->scrub(time); };
    scrub(m_window.rooms().playback->clock().last());
    if (!m_options.view.isEmpty()) {
        m_window.rooms().scene->look(figures::viewFromFile(m_options.view.toStdString()));
    }
    // What is asked for takes the place of the instant of a view.
    if (m_options.time) {
        scrub(*m_options.time);
    }
    m_dialogs.start();
    for (const ActionId id : m_options.actions) {
        if (!m_taken) {
            m_window.actions()[id].trigger();
        }
    }
    m_dialogs.stop();
    if (m_taken) {
        return;
    }
    if (m_options.photo) {
        m_window.findChild<widgets::EvidencePage*>()->setShow(static_cast<widgets::PhotoView::Show>(*m_options.photo));
        m_window.rooms().evidence->compare();
    }
}

void Screenshot::take() {
    m_taken = true;
    m_timer.stop();
    try {
        if (!m_options.chart.isEmpty()) {
            if (const auto report = m_window.rooms().accuracy->work().report()) {
                ChartExport::write(m_options.chart, m_window.findChild<widgets::AccuracyPage*>()->chart(),
                                   m_window.rooms().charts->sweep(*report, m_window.rooms().accuracy->work().machine()));
            }
        }
        if (m_options.screenshot.isEmpty()) {
            QCoreApplication::exit(0);
            return;
        }
        QImage picture = m_window.grab().toImage();
        // A widget that is grabbed paints its captions elsewhere: the views are taken from their own frame buffer.
        for (widgets::ViewWidget* views : {&m_window.area().views(), &m_window.findChild<widgets::EvidencePage*>()->model()}) {
            if (views->isVisible()) {
                QPainter painter(&picture);
                painter.drawImage(QRect(views->mapTo(&m_window, QPoint(0, 0)), views->size()), views->picture());
            }
        }
        // Windows of their own lie over it, as they do on the screen.
        for (QWidget* other : QApplication::topLevelWidgets()) {
            if (other != &m_window && other->isVisible()) {
                QPainter painter(&picture);
                const QPoint corner = other->mapToGlobal(QPoint(0, 0)) - m_window.mapToGlobal(QPoint(0, 0));
                painter.drawPixmap(corner, other->grab());
                for (auto* views : other->findChildren<widgets::ViewWidget*>()) {
                    painter.drawImage(QRect(corner + views->mapTo(other, QPoint(0, 0)), views->size()), views->picture());
                }
            }
        }
        figures::writePng(m_options.screenshot.toStdString(), picture);
        QCoreApplication::exit(0);
    } catch (...) {
        giveUp(*failureOf(std::current_exception()));
    }
}

}  // namespace rubble
