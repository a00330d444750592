#include "core/fe/activity.h"

#include <bit>
#include <cassert>

namespace rubble {

Activity::Activity(std::size_t states, std::size_t elements)
    : m_states(states), m_elements(elements), m_wordsPerState((elements + 63) / 64), m_words(states * m_wordsPerState, 0) {}

void Activity::set(std::size_t state, ElementIndex element, bool active) {
    assert(state < m_states && at(element) < m_elements);
    std::uint64_t& word = m_words[state * m_wordsPerState + (at(element) >> 6)];
    const std::uint64_t bit = std::uint64_t{1} << (at(element) & 63);
    word = active ? (word | bit) : (word & ~bit);
}

std::size_t Activity::activeCount(std::size_t state) const {
    assert(state < m_states);
    std::size_t count = 0;
    for (std::size_t i = 0; i < m_wordsPerState; ++i) {
        count += static_cast<std::size_t>(std::popcount(m_words[state * m_wordsPerState + i]));
    }
    return count;
}

}  // namespace rubble
