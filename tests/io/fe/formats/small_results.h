#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rubble::io {

/// Results of two bricks side by side, of which the second dies between the second and the third of three states at 0, 1 and 2 s,
/// as text in several formats. The nodes move by 0.1 along x from state to state.
/// @param status  with records of the status; without, nothing says that the second dies
std::string smallFil(bool status = true);
std::string smallFrd();
std::string smallMarc(bool removed);
/// One state of three; the time stands in a comment.
std::string smallCdb(int state);
/// What a result file of Ansys says of itself.
struct RstHeader {
    int analysis = 4;            ///< code of ANTYPE: 0 static, 4 transient
    std::size_t words = 80;      ///< of the headers of results and geometry; releases of long ago: 40
    std::size_t setWords = 200;  ///< of the header of a set
    bool unset = false;          ///< displacements along z have no value
    std::vector<int> bricks{};   ///< that one process of a distributed analysis has, from 1; empty: the file is whole
};
/// It has no deaths: a list beside it tells them. @param states  that are written
std::string smallRst(int states, const RstHeader& header = {});
/// A deck with density 2400 and the removal in the third step.
std::string smallDeck();

}  // namespace rubble::io
