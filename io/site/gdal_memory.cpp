#include "io/site/gdal_memory.h"

#include <cpl_vsi.h>

#include <atomic>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/site/gdal_session.h"

namespace rubble::io {

GdalMemoryFile::GdalMemoryFile(const std::string& suffix) {
    static std::atomic<unsigned> counter{0};
    m_name = "/vsimem/rubble-" + std::to_string(counter++) + suffix;
}

GdalMemoryFile::~GdalMemoryFile() {
    const GdalSession session;
    VSIUnlink(m_name.c_str());
    VSIUnlink((m_name + ".aux.xml").c_str());
}

void GdalMemoryFile::save(const std::string& path) const {
    const GdalSession session;
    vsi_l_offset size = 0;
    const GByte* bytes = VSIGetMemFileBuffer(m_name.c_str(), &size, FALSE);
    if (bytes == nullptr || size == 0) {
        failGdal(path);
    }
    writeAtomically(
        path, [&](std::ostream& out) { out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size)); });
}

void failGdal(const std::string& path) {
    throw WorldError(
        {"map.file_failed", "{0} cannot be made: {1}", {path, GdalSession::reason()}},
        {"map.file_failed.remedy", "Choose larger cells if memory is short; else look at the coordinate system of the case.", {}});
}

}  // namespace rubble::io
