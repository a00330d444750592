#pragma once

#include <cstdint>
#include <vector>

#include "core/base/ids.h"

namespace rubble {

/// Which elements are active at which state: one bit each, states x elements.
class Activity {
public:
    Activity() = default;
    Activity(std::size_t states, std::size_t elements);

    void set(std::size_t state, ElementIndex element, bool active);
    bool active(std::size_t state, ElementIndex element) const {
        return (m_words[state * m_wordsPerState + (at(element) >> 6)] >> (at(element) & 63)) & 1u;
    }
    std::size_t activeCount(std::size_t state) const;

    std::size_t states() const { return m_states; }
    std::size_t elements() const { return m_elements; }

private:
    std::size_t m_states = 0;
    std::size_t m_elements = 0;
    std::size_t m_wordsPerState = 0;
    std::vector<std::uint64_t> m_words;
};

}  // namespace rubble
