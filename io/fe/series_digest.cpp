#include "io/fe/series_digest.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <exception>
#include <filesystem>
#include <thread>

#include "io/base/files.h"

namespace rubble::io {

namespace fs = std::filesystem;

namespace {

/// Takes the digests of all files, one after the other on each thread.
class SeriesDigest {
public:
    SeriesDigest(const std::vector<std::string>& files, const Execution& execution)
        : m_files(files), m_execution(execution), m_digests(files.size()), m_errors(files.size()) {
        for (const std::string& file : files) {
            std::error_code error;
            const std::uintmax_t size = fs::file_size(file, error);
            m_bytes += error ? 0.0 : static_cast<double>(size);
        }
    }

    std::vector<std::string> take() {
        const std::size_t threads = std::min(static_cast<std::size_t>(m_execution.threads()), m_files.size());
        {
            std::vector<std::jthread> workers;
            for (std::size_t i = 1; i < threads; ++i) {
                workers.emplace_back([this] { work(); });
            }
            work();
        }
        for (const std::exception_ptr& error : m_errors) {
            if (error) {
                std::rethrow_exception(error);
            }
        }
        m_execution.check();
        return std::move(m_digests);
    }

private:
    void work() {
        for (std::size_t i = m_next++; i < m_files.size() && !m_execution.cancelled(); i = m_next++) {
            try {
                m_digests[i] = sha256OfFile(m_files[i], [this](std::size_t bytes) { advance(bytes); });
            } catch (...) {
                m_errors[i] = std::current_exception();
                return;
            }
        }
    }

    // Progress is told on the caller's thread alone.
    void advance(std::size_t bytes) {
        const std::size_t done = m_done += bytes;
        if (std::this_thread::get_id() == m_caller) {
            m_execution.report({"fe.digest", "Taking the digest of the files", {}},
                               std::min(static_cast<double>(done) / m_bytes, 1.0));
        }
        m_execution.check();
    }

    const std::vector<std::string>& m_files;
    const Execution& m_execution;
    std::vector<std::string> m_digests;
    std::vector<std::exception_ptr> m_errors;
    const std::thread::id m_caller = std::this_thread::get_id();
    double m_bytes = 1.0;
    std::atomic<std::size_t> m_next{0};
    std::atomic<std::size_t> m_done{0};
};

}  // namespace

std::string sha256OfSeries(const std::vector<std::string>& files, const Execution& execution) {
    return sha256OfList(files, SeriesDigest(files, execution).take());
}

std::string sha256OfList(const std::vector<std::string>& files, const std::vector<std::string>& digests) {
    assert(!files.empty() && files.size() == digests.size());
    if (files.size() == 1) {
        return digests.front();
    }
    std::string list;
    for (std::size_t i = 0; i < files.size(); ++i) {
        list += digests[i] + "  " + fs::path(files[i]).filename().string() + "\n";
    }
    return sha256OfText(list);
}

}  // namespace rubble::io
