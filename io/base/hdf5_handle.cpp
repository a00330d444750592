#include "io/base/hdf5_handle.h"

namespace rubble::io {

namespace {

// Where the packaged library failed on a damaged file or a full disk it leaves objects open, and its work at the end of the program
// then crashes or goes round in circles. Every file here is closed by its owner, so nothing waits for that work. To be said before
// the library is used for the first time.
const bool endsWithoutTheLibrary = H5dont_atexit() >= 0;

}  // namespace

Hdf5Session::Hdf5Session() : m_lock(nativeLibraries()) {
    H5Eget_auto2(H5E_DEFAULT, &m_print, &m_printData);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Session::~Hdf5Session() {
    H5Eset_auto2(H5E_DEFAULT, m_print, m_printData);
}

namespace {

// The innermost record stands first when walking upwards; the system's reason hides in its text.
herr_t takeReason(unsigned depth, const H5E_error2_t* record, void* target) {
    auto& reason = *static_cast<std::string*>(target);
    const std::string text = record->desc ? record->desc : "";
    static const std::string mark = "error message = '";
    if (const std::size_t start = text.find(mark); start != std::string::npos) {
        const std::size_t first = start + mark.size();
        reason = text.substr(first, text.find('\'', first) - first);
        return 1;
    }
    if (depth == 0) {
        reason = text;
    }
    return 0;
}

}  // namespace

std::string hdf5Reason() {
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, takeReason, &reason);
    return reason.empty() ? "unknown reason" : reason;
}

}  // namespace rubble::io
