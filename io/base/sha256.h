#pragma once

#include <cstddef>
#include <string>

struct evp_md_ctx_st;

namespace rubble::io {

/// SHA-256 of what it is fed with.
class Sha256 {
public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(const void* bytes, std::size_t size);
    /// Lower-case hex of everything that was added; nothing may be added afterwards.
    std::string hex();

private:
    evp_md_ctx_st* m_context;
};

/// Bytes as lower-case hex.
std::string hexOf(const unsigned char* bytes, std::size_t size);

}  // namespace rubble::io
