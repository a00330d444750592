#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/base/error.h"
#include "io/case/case_file.h"

using namespace rubble;

/// Reads any bytes as a case; one that was read is written, read again and written alike.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    try {
        const std::string text = io::caseText(io::caseFromText({reinterpret_cast<const char*>(bytes), size}, "case"));
        if (io::caseText(io::caseFromText(text, "case")) != text) {
            std::abort();
        }
    } catch (const Error&) {
    }
    return 0;
}
