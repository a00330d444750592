#include "app/python/watched.h"

#include <chrono>
#include <thread>

#include "core/base/error.h"

namespace rubble::python {

namespace {

constexpr std::chrono::milliseconds lookEvery{50};

}  // namespace

WatchedWork::WatchedWork(py::object listener) : m_listener(std::move(listener)) {
    if (!m_listener.is_none() && PyCallable_Check(m_listener.ptr()) == 0) {
        throw UsageError({"python.progress", "progress cannot be called.", {}},
                         {"python.progress.remedy", "Give a function of a text and a number, or None.", {}});
    }
}

void WatchedWork::run(const std::function<void(const Execution&)>& work) {
    const Execution execution([this](const Progress& progress) {
        const std::scoped_lock lock(m_mutex);
        m_news = progress;
        m_changed.notify_one();
    });
    std::thread worker([&] {
        try {
            work(execution);
        } catch (...) {
            m_thrown = std::current_exception();
        }
        const std::scoped_lock lock(m_mutex);
        m_done = true;
        m_changed.notify_one();
    });
    {
        const py::gil_scoped_release released;
        wait(execution);
        worker.join();
    }
    if (m_raised) {
        throw std::move(*m_raised);
    }
    if (m_thrown) {
        std::rethrow_exception(m_thrown);
    }
}

void WatchedWork::wait(const Execution& execution) {
    for (bool done = false; !done;) {
        {
            std::unique_lock lock(m_mutex);
            m_changed.wait_for(lock, lookEvery, [this] { return m_done || m_news; });
            done = m_done;
        }
        const py::gil_scoped_acquire acquired;
        serve(execution);
    }
}

void WatchedWork::serve(const Execution& execution) {
    std::optional<Progress> news;
    {
        const std::scoped_lock lock(m_mutex);
        news.swap(m_news);
    }
    if (m_raised) {
        return;
    }
    try {
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
        if (news && !m_listener.is_none()) {
            const py::object answer = m_listener(englishText(news->stage), news->fraction);
            if (answer.is(py::bool_(false))) {
                execution.cancel();
            }
        }
    } catch (py::error_already_set& raised) {
        m_raised.emplace(std::move(raised));
        execution.cancel();
    }
}

}  // namespace rubble::python
