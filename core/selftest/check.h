#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace rubble::selftest {

enum class Bound { AtMost, AtLeast };

/// One number that a case measures, against its limit.
struct Check {
    std::string name;  ///< "deepest overlap"
    double measured = 0.0;
    double limit = 0.0;
    Bound bound = Bound::AtMost;
    std::string unit;
    double expected = std::numeric_limits<double>::quiet_NaN();  ///< of a closed form; `measured` is then the distance from it
    double value = std::numeric_limits<double>::quiet_NaN();     ///< of a closed form: what was measured itself

    bool closedForm() const { return expected == expected; }
    /// A number that is not finite never passes.
    bool pass() const;
    /// How much of its limit is used up: above 1 it fails.
    double strain() const;
};

/// What a case found.
class Outcome {
public:
    void atMost(std::string_view name, double measured, double limit, std::string_view unit = {});
    void atLeast(std::string_view name, double measured, double limit, std::string_view unit = {});
    /// A closed form: `value` within `tolerance` of `expected`, all in one unit.
    void near(std::string_view name, double value, double expected, double tolerance, std::string_view unit = {});
    /// A count of what must not be.
    void none(std::string_view name, double count) { atMost(name, count, 0.0); }

    const std::vector<Check>& checks() const { return m_checks; }
    /// All pass, and there is at least one.
    bool pass() const;
    /// The check that is closest to its limit, or furthest beyond it; a case without checks has none.
    const Check* governing() const;

private:
    std::vector<Check> m_checks;
};

}  // namespace rubble::selftest
