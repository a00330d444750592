#include "io/fe/fe_copy/file_traces.h"

#include <sys/stat.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/json/json_cursor.h"

namespace rubble::io {

namespace {

using nlohmann::json;

constexpr int traceVersion = 1;

std::int64_t nanoseconds(const timespec& time) {
    return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

}  // namespace

std::vector<FileTrace> tracesOf(const std::vector<std::string>& files) {
    std::vector<FileTrace> traces;
    for (const std::string& file : files) {
        FileTrace& trace = traces.emplace_back();
        std::error_code ignored;
        trace.path = std::filesystem::absolute(file, ignored).lexically_normal().string();
        struct stat status{};
        if (::stat(file.c_str(), &status) == 0) {
            trace.bytes = status.st_size;
            trace.contentNs = nanoseconds(status.st_mtim);
            trace.changeNs = nanoseconds(status.st_ctim);
        }
    }
    return traces;
}

std::uint64_t bytesOf(const std::vector<FileTrace>& traces) {
    std::uint64_t bytes = 0;
    for (const FileTrace& trace : traces) {
        bytes += static_cast<std::uint64_t>(std::max<std::int64_t>(0, trace.bytes));
    }
    return bytes;
}

std::int64_t lastWritten(const std::vector<FileTrace>& traces) {
    std::int64_t last = 0;
    for (const FileTrace& trace : traces) {
        last = std::max(last, trace.contentNs);
    }
    return last;
}

bool sameSizes(const std::vector<FileTrace>& a, const std::vector<FileTrace>& b) {
    bool same = a.size() == b.size();
    for (std::size_t i = 0; same && i < a.size(); ++i) {
        same = a[i].path == b[i].path && a[i].bytes == b[i].bytes;
    }
    return same;
}

std::optional<SeriesTrace> readTrace(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    try {
        const json document = parseJson(text.str(), path);
        const JsonCursor cursor(document, path);
        if (cursor["version"].integer() != traceVersion) {
            return std::nullopt;
        }
        SeriesTrace trace;
        trace.sha256 = cursor["sha256"].text();
        for (const JsonCursor& file : cursor["files"].elements()) {
            trace.files.push_back(
                {file["path"].text(), file["bytes"].integer(), file["content_ns"].integer(), file["change_ns"].integer()});
        }
        return trace;
    } catch (const ParseError&) {
        return std::nullopt;
    }
}

void writeTrace(const std::string& path, const SeriesTrace& trace) {
    json files = json::array();
    for (const FileTrace& file : trace.files) {
        files.push_back({{"path", file.path}, {"bytes", file.bytes}, {"content_ns", file.contentNs}, {"change_ns", file.changeNs}});
    }
    const json object{{"version", traceVersion}, {"sha256", trace.sha256}, {"files", files}};
    writeAtomically(path, [&](std::ostream& out) { out << object.dump(1, ' ', false, json::error_handler_t::replace) << '\n'; });
}

}  // namespace rubble::io
