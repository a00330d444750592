#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/message.h"

namespace rubble {

/// A recoverable finding: what was met, how often, an example with its place, and the remedy. Belongs to the stage that found it.
struct Finding {
    Message what;
    Message remedy;
    std::int64_t count = 0;
    std::string example;
};

/// Findings of one stage, counted by message id and kept in the order in which each kind was first met.
class Findings {
public:
    /// Counts `count` more of the finding with this message id; the first call's texts and example are kept.
    void add(const Message& what, const Message& remedy, std::string_view example = {}, std::int64_t count = 1);
    void append(const Findings& other);

    const std::vector<Finding>& list() const { return m_list; }
    /// The count of the finding with this id, 0 if there is none.
    std::int64_t count(std::string_view id) const;
    bool empty() const { return m_list.empty(); }

private:
    std::vector<Finding> m_list;
};

}  // namespace rubble
