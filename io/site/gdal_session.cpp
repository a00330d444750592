#include "io/site/gdal_session.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>

namespace rubble::io {

GdalSession::GdalSession() : m_lock(nativeLibraries()) {
    static const bool registered = [] {
        GDALAllRegister();
        return true;
    }();
    (void)registered;
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
    // Else whole numbers on the first lines make an integer grid, in which "nan" further down would be read as zero.
    CPLSetThreadLocalConfigOption("AAIGRID_DATATYPE", "Float64");
}

GdalSession::~GdalSession() {
    CPLSetThreadLocalConfigOption("AAIGRID_DATATYPE", nullptr);
    CPLPopErrorHandler();
}

std::string GdalSession::reason() {
    const std::string text = CPLGetLastErrorMsg();
    return text.empty() ? "no more is known" : text;
}

}  // namespace rubble::io
