#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// The names most like a mistyped one, nearest first: by edit distance without regard to case, names that contain it first among
/// equals. At most `count`.
std::vector<std::string> nearestNames(std::string_view wanted, std::span<const std::string> names, std::size_t count = 5);

/// Names as a list for a message: "a", "b", "c"; at most `count` of them, then how many more there are. "none" for an empty list.
std::string quotedList(std::span<const std::string> names, std::size_t count = 20);

}  // namespace rubble
