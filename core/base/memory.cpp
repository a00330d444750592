#include "core/base/memory.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace rubble {

void keepFreedMemory() {
#ifdef __GLIBC__
    constexpr int mapped = 64 << 20, kept = 256 << 20;  // bytes
    mallopt(M_MMAP_THRESHOLD, mapped);
    mallopt(M_TRIM_THRESHOLD, kept);
#endif
}

}  // namespace rubble
