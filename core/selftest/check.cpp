#include "core/selftest/check.h"

#include <algorithm>
#include <cmath>

namespace rubble::selftest {

bool Check::pass() const {
    return std::isfinite(measured) && (bound == Bound::AtMost ? measured <= limit : measured >= limit);
}

double Check::strain() const {
    constexpr double beyond = std::numeric_limits<double>::infinity();
    if (!std::isfinite(measured)) {
        return beyond;
    }
    if (bound == Bound::AtLeast) {
        return measured > 0.0 ? limit / measured : (pass() ? 0.0 : beyond);
    }
    if (limit == 0.0) {
        return pass() ? 0.0 : beyond;
    }
    return measured / limit;
}

void Outcome::atMost(std::string_view name, double measured, double limit, std::string_view unit) {
    m_checks.push_back({std::string(name), measured, limit, Bound::AtMost, std::string(unit)});
}

void Outcome::atLeast(std::string_view name, double measured, double limit, std::string_view unit) {
    m_checks.push_back({std::string(name), measured, limit, Bound::AtLeast, std::string(unit)});
}

void Outcome::near(std::string_view name, double value, double expected, double tolerance, std::string_view unit) {
    m_checks.push_back(
        {std::string(name), std::abs(value - expected), tolerance, Bound::AtMost, std::string(unit), expected, value});
}

bool Outcome::pass() const {
    return !m_checks.empty() && std::all_of(m_checks.begin(), m_checks.end(), [](const Check& check) { return check.pass(); });
}

const Check* Outcome::governing() const {
    const auto worst =
        std::max_element(m_checks.begin(), m_checks.end(), [](const Check& a, const Check& b) { return a.strain() < b.strain(); });
    return worst == m_checks.end() ? nullptr : &*worst;
}

}  // namespace rubble::selftest
