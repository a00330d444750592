#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace rubble::io {

/// What a file is cut off for.
enum class CutOff : std::uint8_t {
    LastFile,   ///< any of it: it holds the last state alone
    LastState,  ///< what has come since the second state
    Refused,    ///< its library opens no file that is cut off
};

/// A result of three states, a second apart, in one format: how it is written up to its second or third. An element dies at the
/// third, or nothing says that anything dies.
struct Growing {
    std::string name;
    std::string opened;  ///< file
    /// Replaces what is there. @param told  the result says by itself which elements are dead
    std::function<void(const TemporaryFolder& folder, int states, bool told)> write;
    std::string last{};  ///< file of the third state alone that no index names; empty: there is none
    std::string cut{};   ///< file whose end may be missing
    CutOff cutOff = CutOff::LastFile;
    std::size_t filled = 0;   ///< bytes of the last file that say something, where it is filled up; 0: all
    std::int64_t dying = 2;   ///< number of the element that dies
    bool tells = true;        ///< false: where `told`, deaths are concluded or stand in a list
    bool mayBeSilent = true;  ///< there are results of this format that do not tell which elements are dead
};

void PrintTo(const Growing& growing, std::ostream* out);

std::vector<Growing> allGrowing();
/// A mesh of one file whose states come with its deaths, so that it does not grow.
Growing oneCdb();

}  // namespace rubble::io
