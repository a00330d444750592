#include "io/base/run_driver.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <map>

namespace rubble::io {

namespace {

constexpr haddr_t pageSize = 4096;
constexpr haddr_t largestAddress = (haddr_t{1} << 62) - 1;

int openError = 0;

struct RunDriverFile : H5FD_t {
    int fd = -1;
    bool writable = false;
    dev_t device = 0;
    ino_t inode = 0;
    haddr_t endOfAddresses = 0;
    haddr_t endOfFile = 0;
    int error = 0;  ///< of the first write that failed
    /// What was written after that, by page.
    std::map<haddr_t, std::array<char, pageSize>> pages;
};

RunDriverFile& of(H5FD_t* file) {
    return *static_cast<RunDriverFile*>(file);
}
const RunDriverFile& of(const H5FD_t* file) {
    return *static_cast<const RunDriverFile*>(file);
}

H5FD_t* openFile(const char* name, unsigned flags, hid_t, haddr_t) {
    int mode = flags & H5F_ACC_RDWR ? O_RDWR : O_RDONLY;
    mode |= (flags & H5F_ACC_CREAT ? O_CREAT : 0) | (flags & H5F_ACC_EXCL ? O_EXCL : 0) | (flags & H5F_ACC_TRUNC ? O_TRUNC : 0);
    const int fd = ::open(name, mode | O_CLOEXEC, 0666);
    struct stat status{};
    if (fd < 0 || ::fstat(fd, &status) != 0) {
        openError = errno;
        if (fd >= 0) {
            ::close(fd);
        }
        return nullptr;
    }
    auto* file = new RunDriverFile();
    file->fd = fd;
    file->writable = (flags & H5F_ACC_RDWR) != 0;
    file->device = status.st_dev;
    file->inode = status.st_ino;
    file->endOfFile = static_cast<haddr_t>(status.st_size);
    return file;
}

herr_t closeFile(H5FD_t* file) {
    ::close(of(file).fd);
    delete &of(file);
    return 0;
}

template <class T>
int order(const T& a, const T& b) {
    return a < b ? -1 : b < a ? 1 : 0;
}

int compareFiles(const H5FD_t* a, const H5FD_t* b) {
    if (const int byDevice = order(of(a).device, of(b).device)) {
        return byDevice;
    }
    if (const int byInode = order(of(a).inode, of(b).inode)) {
        return byInode;
    }
    return of(a).writable || of(b).writable ? 0 : order(a, b);
}

herr_t query(const H5FD_t*, unsigned long* flags) {
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA |
             H5FD_FEAT_SUPPORTS_SWMR_IO | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
}

haddr_t endOfAddresses(const H5FD_t* file, H5FD_mem_t) {
    return of(file).endOfAddresses;
}

herr_t setEndOfAddresses(H5FD_t* file, H5FD_mem_t, haddr_t address) {
    of(file).endOfAddresses = address;
    return 0;
}

haddr_t endOfFile(const H5FD_t* file, H5FD_mem_t) {
    return of(file).endOfFile;
}

herr_t handle(H5FD_t* file, hid_t, void** result) {
    *result = file;
    return 0;
}

// Reads from the file itself; zeros beyond its end.
bool readThrough(const RunDriverFile& file, haddr_t address, std::size_t size, char* out) {
    while (size > 0) {
        const ssize_t got = ::pread(file.fd, out, size, static_cast<off_t>(address));
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got < 0) {
            return false;
        }
        if (got == 0) {
            std::memset(out, 0, size);
            return true;
        }
        address += static_cast<haddr_t>(got);
        out += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

// Calls work(page, start within the page, start within the block, bytes) for every page that a block touches.
template <class Work>
void forPages(haddr_t address, std::size_t size, const Work& work) {
    for (std::size_t done = 0; done < size;) {
        const haddr_t start = (address + done) % pageSize;
        const std::size_t bytes = std::min<std::size_t>(size - done, pageSize - start);
        work((address + done) / pageSize, start, done, bytes);
        done += bytes;
    }
}

herr_t readFile(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* buffer) {
    const RunDriverFile& file = of(base);
    if (address > largestAddress || size > largestAddress || !readThrough(file, address, size, static_cast<char*>(buffer))) {
        return -1;
    }
    if (!file.pages.empty()) {
        forPages(address, size, [&](haddr_t page, haddr_t start, std::size_t done, std::size_t bytes) {
            if (const auto known = file.pages.find(page); known != file.pages.end()) {
                std::memcpy(static_cast<char*>(buffer) + done, known->second.data() + start, bytes);
            }
        });
    }
    return 0;
}

void keepInMemory(RunDriverFile& file, haddr_t address, std::size_t size, const char* bytes) {
    forPages(address, size, [&](haddr_t page, haddr_t start, std::size_t done, std::size_t count) {
        const auto [entry, fresh] = file.pages.try_emplace(page);
        if (fresh && !readThrough(file, page * pageSize, pageSize, entry->second.data())) {
            entry->second.fill(0);
        }
        std::memcpy(entry->second.data() + start, bytes + done, count);
    });
}

herr_t writeFile(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, const void* buffer) {
    RunDriverFile& file = of(base);
    const char* bytes = static_cast<const char*>(buffer);
    if (address > largestAddress || size > largestAddress) {
        return -1;
    }
    file.endOfFile = std::max<haddr_t>(file.endOfFile, address + size);
    while (size > 0 && file.error == 0) {
        const ssize_t written = ::pwrite(file.fd, bytes, size, static_cast<off_t>(address));
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            file.error = written < 0 ? errno : ENOSPC;
            break;
        }
        address += static_cast<haddr_t>(written);
        bytes += written;
        size -= static_cast<std::size_t>(written);
    }
    if (size > 0) {
        keepInMemory(file, address, size, bytes);
    }
    return 0;
}

herr_t truncateFile(H5FD_t* base, hid_t, hbool_t) {
    RunDriverFile& file = of(base);
    if (!file.writable || file.endOfAddresses == file.endOfFile) {
        return 0;
    }
    if (file.error == 0 && ::ftruncate(file.fd, static_cast<off_t>(file.endOfAddresses)) != 0) {
        file.error = errno;
    }
    file.endOfFile = file.endOfAddresses;
    return 0;
}

H5FD_class_t makeDriver() {
    H5FD_class_t driver{};
    driver.name = "rubble_run";
    driver.maxaddr = largestAddress;
    driver.fc_degree = H5F_CLOSE_WEAK;
    driver.open = openFile;
    driver.close = closeFile;
    driver.cmp = compareFiles;
    driver.query = query;
    driver.get_eoa = endOfAddresses;
    driver.set_eoa = setEndOfAddresses;
    driver.get_eof = endOfFile;
    driver.get_handle = handle;
    driver.read = readFile;
    driver.write = writeFile;
    driver.truncate = truncateFile;
    constexpr H5FD_mem_t places[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(places), std::end(places), std::begin(driver.fl_map));
    return driver;
}

hid_t driverId() {
    static const H5FD_class_t driver = makeDriver();
    static const hid_t id = H5FDregister(&driver);
    return id;
}

}  // namespace

Hdf5Handle runFileAccess() {
    Hdf5Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_driver(list.get(), driverId(), nullptr);
    // Readers beside a writer need the newest form of the file's own structures.
    H5Pset_libver_bounds(list.get(), H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
    return list;
}

int runDriverError(hid_t file) {
    void* found = nullptr;
    return file >= 0 && H5Fget_vfd_handle(file, H5P_DEFAULT, &found) >= 0 ? of(static_cast<H5FD_t*>(found)).error : 0;
}

int runDriverOpenError() {
    return openError;
}

}  // namespace rubble::io
