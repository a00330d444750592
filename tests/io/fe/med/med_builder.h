#pragma once

#include <map>
#include <string>
#include <vector>

namespace rubble::io {

/// Cells of one MED type.
struct MedBlockRows {
    int type = 308;
    std::vector<int> nodes;     ///< 1-based
    std::vector<int> numbers;   ///< empty: none
    std::vector<int> families;  ///< empty: none
};

/// Values of a field at one step.
struct MedFieldRows {
    std::string name;
    std::vector<std::string> components;
    int step = 0;
    double time = 0.0;
    int type = 0;                ///< of the cells; 0: nodes
    std::vector<int> profile;    ///< 1-based entities that have values; empty: all
    std::vector<double> values;  ///< [entities x components]
    bool onCellNodes = false;    ///< a value at each node of a cell
};

/// What a MED file holds.
struct MedRows {
    std::vector<double> places;  ///< [nodes x dimensions]
    int dimensions = 3;
    std::vector<MedBlockRows> blocks;
    std::map<int, std::vector<std::string>> groups;  ///< by family
    std::vector<MedFieldRows> fields;
};

/// Opens a file through libmed without our care and asks for what damage may lie in; what goes wrong is not looked at.
void touchMed(const std::string& path);
/// Writes it through libmed.
void writeMed(const std::string& path, const MedRows& rows);

/// Two bricks side by side in groups PIER and DECK with the four faces of their ends, moved by 0.1 along x from state to state; at
/// the third of three states no field has values on the second brick.
MedRows twoBricksMed();

}  // namespace rubble::io
