#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "io/json/json_cursor.h"
#include "io/run/run_columns.h"
#include "io/run/run_file.h"
#include "io/run/run_store.h"

namespace rubble::io {

namespace {

// Bytes read at a time: bounds the memory of the check.
constexpr std::size_t blockBytes = std::size_t{4} << 20;

Digest digestOf(const RunColumns& columns, RunDataset dataset, const Execution& execution) {
    const std::size_t rowBytes = layoutOf(dataset).rowBytes;
    const std::uint64_t rows = columns.rows(dataset);
    const std::uint64_t block = std::max<std::uint64_t>(1, std::min(rows, blockBytes / rowBytes));
    std::vector<std::byte> buffer(block * rowBytes);
    Hasher hasher;
    for (std::uint64_t from = 0; from < rows; from += block) {
        const std::uint64_t count = std::min(block, rows - from);
        columns.read(dataset, from, count, buffer.data());
        hasher.bytes(buffer.data(), count * rowBytes);
        execution.report(Message{"io.run.checking", "Checking {0}", {layoutOf(dataset).path}},
                         static_cast<double>(from + count) / static_cast<double>(rows));
    }
    return hasher.finish();
}

}  // namespace

void checkRunDigest(const std::string& path, const Execution& execution) {
    const RunColumns columns(path);
    const std::string written = columns.text(RunDataset::Digests);
    if (written.empty()) {
        throw ParseError(Message{"io.run.incomplete", "{0} is not complete: its run was stopped before the end", {path}},
                         Message{"io.run.incomplete.remedy", "Run the case again to the end.", {}});
    }
    const std::string place = layoutOf(RunDataset::Digests).path;
    const nlohmann::json text = parseJson(written, path + ": " + place);
    const JsonCursor list = JsonCursor(text, path, place)["datasets"];
    std::vector<DatasetDigest> found;
    for (const RunDataset dataset : runDatasets()) {
        if (dataset == RunDataset::Digests || !columns.has(dataset)) {
            continue;
        }
        found.push_back({dataset, columns.rows(dataset), digestOf(columns, dataset, execution)});
        const JsonCursor entry = list[layoutOf(dataset).path];
        if (entry["rows"].value() != found.back().rows || entry["hash"].text() != found.back().hash.hex()) {
            columns.failContent(dataset, "its content is not what the run wrote");
        }
    }
    if (digestsText(found) != written) {
        columns.failContent(RunDataset::Digests, "its content is not what the run wrote");
    }
}

}  // namespace rubble::io
