#include "app/gui/window/speed_measure.h"

#include <unistd.h>

#include <QApplication>
#include <QEvent>
#include <QEventLoop>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <random>
#include <string>

#include "app/gui/session/session.h"
#include "app/gui/stage/playback.h"
#include "app/gui/stage/status_feed.h"
#include "app/gui/stage/view_area.h"
#include "app/gui/window/main_window.h"

namespace rubble {

namespace {

constexpr int instantsVisited = 60;
constexpr int longestWait = 10'000;  // ms, for one instant
constexpr double mib = 1024.0 * 1024.0;

/// The most memory this process ever had, MiB; 0 if the system does not say.
double peakMemory() {
    std::ifstream file("/proc/self/status");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("VmHWM:")) {
            return std::stod(line.substr(6)) / 1024.0;
        }
    }
    return 0.0;
}

QJsonObject summary(std::vector<double> ms) {
    std::sort(ms.begin(), ms.end());
    const auto at = [&](double share) { return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))]; };
    return {{"instants", static_cast<int>(ms.size())}, {"median_ms", at(0.5)}, {"p95_ms", at(0.95)}, {"worst_ms", ms.back()}};
}

}  // namespace

double secondsSinceStart() {
    std::ifstream file("/proc/self/stat");
    std::string text;
    std::getline(file, text);
    // The name of the program may hold anything; 20 fields come after it up to the time of its start, in ticks since boot.
    const std::size_t name = text.rfind(')');
    if (name == std::string::npos) {
        return 0.0;
    }
    const QStringList fields = QString::fromStdString(text.substr(name + 2)).split(u' ');
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now);
    const double started = fields.value(19).toDouble() / static_cast<double>(sysconf(_SC_CLK_TCK));
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) - started;
}

SpeedMeasure::SpeedMeasure(MainWindow& window, const Options& options) : m_window(window), m_options(options) {
    window.installEventFilter(this);
    connect(&window.area().views(), &widgets::ViewWidget::shown, this, [this] {
        if (!m_firstPicture && m_opening.isValid() && m_window.session().computation().inputs().fe != nullptr) {
            m_firstPicture = static_cast<double>(m_opening.nsecsElapsed()) * 1e-9;
        }
    });
    connect(&window.session().computation(), &Computation::prepared, this, [this] {
        if (!m_prepared && m_window.session().computation().results().clustering != nullptr) {
            m_prepared = static_cast<double>(m_opening.nsecsElapsed()) * 1e-9;
        }
    });
    const auto giveUp = [this](const Failure& failure) {
        std::fprintf(stderr, "rubble: %s %s\n", qPrintable(failure.what()), qPrintable(failure.remedy()));
        m_timer.stop();
        emit finished(1);
    };
    connect(&window.session().computation(), &Computation::failed, this, giveUp);
    // Where nothing could be read, what was open stays.
    connect(&window.session().computation(), &Computation::opened, this, [giveUp](const Opened& opened) {
        if (opened.fe == nullptr && opened.failure) {
            giveUp(*opened.failure);
        }
    });
    connect(&m_timer, &QTimer::timeout, this, &SpeedMeasure::look);
}

bool SpeedMeasure::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Paint && !m_firstWindow) {
        m_firstWindow = 0.0;
        // Once all that is painted along with the window is on the screen.
        QTimer::singleShot(0, this, &SpeedMeasure::begin);
    }
    return QObject::eventFilter(watched, event);
}

void SpeedMeasure::begin() {
    m_firstWindow = secondsSinceStart();
    m_opening.start();
    m_window.open(m_options.path);
    m_timer.start(50);
}

std::vector<double> SpeedMeasure::instants() const {
    const widgets::PlaybackClock& clock = m_window.rooms().playback->clock();
    std::mt19937 random(1);
    const auto anywhere = [&](std::mt19937& from) {
        const double share = static_cast<double>(from()) / static_cast<double>(std::mt19937::max());
        return clock.first() + share * (clock.last() - clock.first());
    };
    std::vector<double> times(instantsVisited);
    std::generate(times.begin(), times.end(), [&] { return anywhere(random); });
    return times;
}

std::vector<double> SpeedMeasure::scrub(const std::vector<double>& times) {
    std::vector<double> spent;
    for (const double time : times) {
        QEventLoop drawn;
        const auto connection = connect(&m_window.area().views(), &widgets::ViewWidget::shown, &drawn, &QEventLoop::quit);
        QTimer::singleShot(longestWait, &drawn, &QEventLoop::quit);
        QElapsedTimer clock;
        clock.start();
        m_window.rooms().playback->scrub(time);
        drawn.exec();
        spent.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
        disconnect(connection);
    }
    return spent;
}

void SpeedMeasure::look() {
    Computation& computation = m_window.session().computation();
    const RunRecord* record = computation.currentRun();
    const bool simulated = record != nullptr && record->outcome != nullptr;
    if (computation.busy() || !m_firstPicture || !m_prepared || (m_simulating && !simulated)) {
        return;
    }
    if (m_options.simulate && !m_simulating) {
        m_simulating = true;
        m_window.rooms().runs->simulate(false);
        return;
    }
    m_timer.stop();
    m_window.rooms().playback->clock().pause();
    report();
    emit finished(0);
}

void SpeedMeasure::report() {
    const std::vector<double> times = instants();
    const std::vector<double> first = scrub(times);
    const std::vector<double> again = scrub(times);
    const FeResult& fe = *m_window.session().computation().inputs().fe;
    const QJsonObject result{{"file", m_options.path},
                             {"elements", static_cast<qint64>(fe.mesh().elementCount())},
                             {"states", static_cast<qint64>(fe.stateCount())},
                             {"window", QStringLiteral("%1x%2").arg(m_window.width()).arg(m_window.height())},
                             {"first_window_s", *m_firstWindow},
                             {"first_picture_s", *m_firstPicture},
                             {"prepared_s", *m_prepared},
                             {"simulated", m_simulating},
                             {"scrub_first_visit", summary(first)},
                             {"scrub_again", summary(again)},
                             {"memory_cap_mib", m_window.session().preferences().memoryMib},
                             {"memory_mib", static_cast<double>(residentMemory()) / mib},
                             {"memory_peak_mib", peakMemory()}};
    std::printf("%s", QJsonDocument(result).toJson().constData());
    std::fflush(stdout);
}

}  // namespace rubble
