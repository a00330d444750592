#include "core/base/finding.h"

#include <algorithm>

namespace rubble {

void Findings::add(const Message& what, const Message& remedy, std::string_view example, std::int64_t count) {
    const auto known = std::find_if(m_list.begin(), m_list.end(), [&](const Finding& f) { return f.what.id == what.id; });
    if (known == m_list.end()) {
        m_list.push_back({what, remedy, count, std::string(example)});
    } else {
        known->count += count;
    }
}

void Findings::append(const Findings& other) {
    for (const Finding& finding : other.m_list) {
        add(finding.what, finding.remedy, finding.example, finding.count);
    }
}

std::int64_t Findings::count(std::string_view id) const {
    const auto known = std::find_if(m_list.begin(), m_list.end(), [&](const Finding& f) { return f.what.id == id; });
    return known == m_list.end() ? 0 : known->count;
}

}  // namespace rubble
