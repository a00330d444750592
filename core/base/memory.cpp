#include "core/base/memory.h"

#include <cstdint>
#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rubble {

void keepFreedMemory() {
#ifdef __GLIBC__
    constexpr int mapped = 64 << 20, kept = 256 << 20;  // bytes
    mallopt(M_MMAP_THRESHOLD, mapped);
    mallopt(M_TRIM_THRESHOLD, kept);
#endif
}

void takeLargePages(void* from, std::size_t bytes) {
#ifdef __linux__
    constexpr std::uintptr_t page = 2 << 20;  // bytes
    const auto first = reinterpret_cast<std::uintptr_t>(from);
    const std::uintptr_t before = (page - first % page) % page;
    if (bytes >= before + page) {
        ::madvise(static_cast<char*>(from) + before, (bytes - before) / page * page, MADV_HUGEPAGE);
    }
#endif
}

}  // namespace rubble
