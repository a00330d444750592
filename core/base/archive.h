#pragma once

#include <array>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry.h"

namespace rubble {

/// A state as bytes, out of memory or back into it. A class visits its members once, in one function for both directions: a member
/// or a function of its namespace, `keep(archive)` or `keep(archive, value)`. Numbers keep every bit; their layout is that of this
/// build, so whoever reads makes sure that the bytes are of the same one, and whole. Containers are bounded by the bytes that are
/// left.
class Archive {
public:
    /// Writes.
    Archive() = default;
    /// Reads these bytes, which must outlive the archive.
    explicit Archive(std::string_view bytes) : m_in(bytes), m_reading(true) {}

    bool reading() const { return m_reading; }
    /// Makes room for so many bytes to be written.
    void reserve(std::size_t bytes) { m_out.reserve(bytes); }
    /// What was written.
    std::string take() && { return std::move(m_out); }
    bool atEnd() const { return m_in.empty(); }
    /// Throws the ParseError of bytes that are not what they should be.
    [[noreturn]] static void fail();

    template <class... Values>
    void operator()(Values&... values) {
        (visit(values), ...);
    }

    void bytes(void* memory, std::size_t size) {
        if (!m_reading) {
            m_out.append(static_cast<const char*>(memory), size);
            return;
        }
        if (size > m_in.size()) {
            fail();
        }
        if (size > 0) {
            std::memcpy(memory, m_in.data(), size);
        }
        m_in.remove_prefix(size);
    }

    /// Number of things that follow, at least a byte each.
    std::size_t count(std::size_t things) {
        std::uint64_t number = things;
        bytes(&number, sizeof number);
        if (m_reading && number > m_in.size()) {
            fail();
        }
        return static_cast<std::size_t>(number);
    }

private:
    template <class T>
    static constexpr bool plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

    template <class T>
    void visit(T& value) {
        if constexpr (requires { value.keep(*this); }) {
            value.keep(*this);
        } else if constexpr (requires { keep(*this, value); }) {
            keep(*this, value);
        } else if constexpr (std::is_same_v<T, bool>) {
            auto byte = static_cast<std::uint8_t>(value);
            bytes(&byte, 1);
            value = byte != 0;
        } else if constexpr (plain<T>) {
            bytes(&value, sizeof value);
        } else if constexpr (requires { value.coeffs(); }) {
            visit(value.coeffs());
        } else {
            // A matrix of fixed size.
            static_assert(T::SizeAtCompileTime > 0);
            bytes(value.data(), sizeof(typename T::Scalar) * static_cast<std::size_t>(T::SizeAtCompileTime));
        }
    }
    void visit(Aabb& box) { (*this)(box.min(), box.max()); }
    void visit(Pose& pose) { (*this)(pose.position, pose.orientation); }
    void visit(OrientedBox& box) { (*this)(box.centre, box.orientation, box.halfExtents); }
    void visit(std::string& text) {
        text.resize(count(text.size()));
        bytes(text.data(), text.size());
    }
    void visit(std::vector<bool>& flags) {
        flags.resize(count(flags.size()));
        for (std::size_t i = 0; i < flags.size(); ++i) {
            bool flag = flags[i];
            visit(flag);
            flags[i] = flag;
        }
    }
    template <class T>
    void visit(std::vector<T>& list) {
        list.resize(count(list.size()));
        if constexpr (plain<T>) {
            if (list.size() > m_in.size() / sizeof(T) && m_reading) {
                fail();
            }
            bytes(list.data(), list.size() * sizeof(T));
        } else {
            for (T& value : list) {
                visit(value);
            }
        }
    }
    template <class T, std::size_t size>
    void visit(std::array<T, size>& list) {
        for (T& value : list) {
            visit(value);
        }
    }
    template <class T>
    void visit(std::optional<T>& value) {
        bool there = value.has_value();
        visit(there);
        if (m_reading) {
            value.reset();
        }
        if (there) {
            visit(m_reading ? value.emplace() : *value);
        }
    }
    template <class Key, class T>
    void visit(std::map<Key, T>& entries) {
        const std::size_t size = count(entries.size());
        if (!m_reading) {
            for (auto& [key, value] : entries) {
                Key copy = key;
                (*this)(copy, value);
            }
            return;
        }
        entries.clear();
        for (std::size_t i = 0; i < size; ++i) {
            Key key{};
            visit(key);
            visit(entries[key]);
        }
    }

    std::string m_out;
    std::string_view m_in;
    bool m_reading = false;
};

}  // namespace rubble
