#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rubble::io {

/// Elements of one class as the recorder mpco of OpenSees writes them.
struct MpcoClassRows {
    std::string name;       ///< "56-Brick[400:0]"
    std::size_t width = 9;  ///< number and nodes
    std::vector<int> rows;  ///< [elements x width]
    int geometry = 0;       ///< attribute GEOMETRY; 0: none
};

/// A stage of the model and its states.
struct MpcoStageRows {
    int number = 1;
    std::vector<int> nodes;
    std::vector<double> places;  ///< [nodes x dimensions]
    std::vector<MpcoClassRows> classes;
    std::vector<std::pair<int, double>> states;  ///< step and time; nodes have moved by 0.1 times the step along x
    std::vector<std::pair<int, double>> fibres;  ///< element and the area of its only fibre
    int cutState = -1;                           ///< step whose table lacks the last node
};

/// Writes a file as the recorder does, by calls of HDF5.
void writeMpco(const std::string& path, const std::vector<MpcoStageRows>& stages, std::size_t dimensions = 3,
               const std::string& result = "DISPLACEMENT");

/// Two bricks side by side, of which the second is removed between 1 and 2 s: two stages of two states and one.
std::vector<MpcoStageRows> twoBricksMpco();

}  // namespace rubble::io
