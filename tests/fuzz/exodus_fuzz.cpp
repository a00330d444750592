#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>
#include <string>

#include "core/base/error.h"
#include "core/fe/audit.h"
#include "io/exodus/exodus_reader.h"

using namespace rubble;

/// Opens any bytes as an FE result and audits what comes out. Errors of ours are answers; anything else is a finding.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const std::string path =
        (std::filesystem::temp_directory_path() / ("rubble-fuzz-" + std::to_string(::getpid()) + ".exo")).string();
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
    try {
        const FeResult fe(io::readExodus(path, {}, {}, Execution{}));
        for (std::size_t k = 0; k < fe.stateCount(); ++k) {
            fe.state(k);
        }
        auditDeaths(fe, groupComponents(fe.mesh(), {}, {}, {}), Execution{});
    } catch (const Error&) {
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
        // openFe() says of both that the file asks for more memory than there is.
    }
    std::filesystem::remove(path);
    return 0;
}
