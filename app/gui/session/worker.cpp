#include "app/gui/session/worker.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <new>

#include "core/base/error.h"
#include "widgets/basics/wording.h"

namespace rubble {

namespace {

std::atomic<int>& threadsOfWork() {
    static std::atomic<int> threads{0};
    return threads;
}

}  // namespace

void Worker::useThreads(int threads) {
    threadsOfWork() = threads;
}

Worker::Worker(QObject* parent) : QObject(parent) {
    m_thread = std::thread([this] { loop(); });
}

Worker::~Worker() {
    {
        const std::lock_guard lock(m_mutex);
        m_stopping = true;
        m_waiting.clear();
        m_execution.cancel();
    }
    m_wake.notify_all();
    m_thread.join();
}

void Worker::start(Job job) {
    cancel(job.kind);
    enqueue(std::move(job));
}

void Worker::startNext(Job job) {
    dropWaiting(job.kind);
    enqueue(std::move(job));
}

void Worker::queue(Job job) {
    job.queued = true;
    enqueue(std::move(job));
}

void Worker::enqueue(Job job) {
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.push_back(std::move(job));
    }
    m_wake.notify_all();
    emit changed();
}

void Worker::dropWaiting(Kind kind) {
    const std::lock_guard lock(m_mutex);
    std::erase_if(m_waiting, [&](const Job& waiting) { return waiting.kind == kind; });
}

void Worker::cancel() {
    std::deque<Job> dropped;
    {
        const std::lock_guard lock(m_mutex);
        dropped.swap(m_waiting);
        std::erase_if(dropped, [](const Job& job) { return !job.queued; });
        for (const Job& job : dropped) {
            m_finishing.push_back(job.kind);
        }
        m_execution.cancel();
    }
    // Somebody waits for each that was queued, such as a dialog that shows it.
    for (Job& job : dropped) {
        tellEnd(std::move(job.finish), std::make_exception_ptr(Cancelled()));
    }
}

void Worker::cancel(Kind kind) {
    dropWaiting(kind);
    const std::lock_guard lock(m_mutex);
    if (m_running == kind) {
        m_execution.cancel();
    }
}

bool Worker::busy() const {
    const std::lock_guard lock(m_mutex);
    return m_running.has_value() || !m_waiting.empty() || !m_finishing.empty();
}

int Worker::waiting() const {
    const std::lock_guard lock(m_mutex);
    return static_cast<int>(m_waiting.size());
}

bool Worker::busy(Kind kind) const {
    const std::lock_guard lock(m_mutex);
    return m_running == kind || std::find(m_finishing.begin(), m_finishing.end(), kind) != m_finishing.end() ||
           std::any_of(m_waiting.begin(), m_waiting.end(), [&](const Job& waiting) { return waiting.kind == kind; });
}

void Worker::loop() {
    while (true) {
        std::unique_lock lock(m_mutex);
        m_wake.wait(lock, [this] { return m_stopping || !m_waiting.empty(); });
        if (m_stopping) {
            return;
        }
        Job job = std::move(m_waiting.front());
        m_waiting.pop_front();
        m_running = job.kind;
        m_execution = Execution([this, kind = job.kind](const Progress& progress) { noteProgress(kind, progress); });
        const int threads = threadsOfWork();
        const Execution execution = threads > 0 ? m_execution.withThreads(threads) : m_execution;
        lock.unlock();
        QMetaObject::invokeMethod(this, [this] { emit changed(); }, Qt::QueuedConnection);
        runOne(job, execution);
    }
}

void Worker::noteProgress(Kind kind, const Progress& progress) {
    const std::lock_guard lock(m_progressMutex);
    const bool waits = m_latest.has_value();
    m_latest.emplace(kind, progress);
    if (waits) {
        return;
    }
    QMetaObject::invokeMethod(
        this,
        [this] {
            std::unique_lock taking(m_progressMutex);
            const auto latest = std::exchange(m_latest, std::nullopt);
            taking.unlock();
            m_told = latest;
            emit progressed(latest->first, latest->second);
        },
        Qt::QueuedConnection);
}

void Worker::tellProgress() {
    if (m_told && busy(m_told->first)) {
        emit progressed(m_told->first, m_told->second);
    }
}

void Worker::runOne(Job& job, const Execution& execution) {
    std::exception_ptr thrown;
    try {
        job.work(execution);
    } catch (...) {
        thrown = std::current_exception();
    }
    {
        const std::lock_guard lock(m_mutex);
        m_running.reset();
        m_finishing.push_back(job.kind);
    }
    tellEnd(std::move(job.finish), thrown);
}

void Worker::tellEnd(std::function<void(std::exception_ptr)> finish, const std::exception_ptr& thrown) {
    QMetaObject::invokeMethod(
        this,
        [this, finish = std::move(finish), thrown] {
            {
                // Finished in the order in which they ran.
                const std::lock_guard lock(m_mutex);
                m_finishing.erase(m_finishing.begin());
            }
            m_told.reset();
            finish(thrown);
            emit changed();
        },
        Qt::QueuedConnection);
}

std::optional<Failure> failureOf(std::exception_ptr exception) {
    if (exception == nullptr) {
        return std::nullopt;
    }
    try {
        std::rethrow_exception(exception);
    } catch (const Cancelled&) {
        return std::nullopt;
    } catch (const Error& error) {
        return Failure{[what = error.message()] { return widgets::worded(what); },
                       [remedy = error.remedy()] { return widgets::worded(remedy); }, error.message().id};
    } catch (const std::bad_alloc&) {
        return Failure{[] { return Worker::tr("There is not enough memory for this."); },
                       [] { return Worker::tr("Close other programs or choose a coarser Basic Grid."); }, "gui.memory"};
    } catch (const std::exception& error) {
        return Failure{[what = QString::fromUtf8(error.what())] { return what; },
                       [] { return Worker::tr("This should not happen: please report it with the file."); }, "gui.unexpected"};
    }
}

QString Failure::inOneLine() const {
    const QString sentence = what();
    static constexpr std::array<char16_t, 6> ends{u'.', u'!', u'?', u':', u'。', u'；'};
    if (sentence.isEmpty() || std::find(ends.begin(), ends.end(), sentence.back().unicode()) != ends.end()) {
        return sentence + QLatin1Char(' ') + remedy();
    }
    return sentence + (sentence.back().script() == QChar::Script_Han ? QStringLiteral("。") : QStringLiteral(". ")) + remedy();
}

}  // namespace rubble
