#include <string>

#include "io/seal/seal_check.h"
#include "io/seal/zip_container.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

/// Checks any bytes as a sealed bundle, and reads each entry of the container; no entry is longer than it says.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string path = layDown(bytes, size, "case.rubblecase");
    try {
        io::ZipReader zip(path);
        io::ZipLayout layout;
        for (const io::ZipReader::Entry& entry : zip.entries()) {
            std::uint64_t read = 0;
            try {
                layout.open(entry.name, entry.bytes);
                zip.read(entry, [&](const char* data, std::size_t count) {
                    layout.write(data, count);
                    read += count;
                });
                layout.close();
                if (read != entry.bytes) {
                    __builtin_trap();
                }
            } catch (const Error&) {
                layout.close();
            }
        }
        layout.firstDifference(path);
    } catch (const Error&) {
    }
    try {
        io::checkBundle(path, {}, fuzzExecution());
    } catch (const Error&) {
    }
    return 0;
}
