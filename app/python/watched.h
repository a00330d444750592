#pragma once

#include <pybind11/pybind11.h>

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>

#include "core/base/execution.h"

namespace rubble::python {

namespace py = pybind11;

/// Does long work on a thread of its own while the calling thread stays with Python: it looks for signals twenty times a second, so
/// that Ctrl-C cancels, and calls the listener with what has been reported since.
class WatchedWork {
public:
    /// @param listener  None, or a callable (stage: str, fraction: float); returning False cancels. What it raises cancels and is
    ///                  raised from run()
    explicit WatchedWork(py::object listener);

    /// Throws what the work throws (Cancelled after a cancel by the listener), or what Python raised.
    void run(const std::function<void(const Execution&)>& work);

private:
    void wait(const Execution& execution);
    void serve(const Execution& execution);

    py::object m_listener;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::optional<Progress> m_news;
    bool m_done = false;
    std::exception_ptr m_thrown;                    ///< by the work
    std::optional<py::error_already_set> m_raised;  ///< by Python
};

/// The same for work with a result.
template <class Work>
auto watched(py::object listener, Work&& work) {
    using Result = decltype(work(std::declval<const Execution&>()));
    std::optional<Result> result;
    WatchedWork(std::move(listener)).run([&](const Execution& execution) { result.emplace(work(execution)); });
    return std::move(*result);
}

}  // namespace rubble::python
