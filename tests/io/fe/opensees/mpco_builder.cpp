#include "tests/io/fe/opensees/mpco_builder.h"

#include <hdf5.h>

#include "io/base/hdf5_handle.h"

namespace rubble::io {

namespace {

template <class T>
Hdf5Handle putTable(hid_t file, const std::string& name, const std::vector<T>& values, std::size_t columns) {
    const hid_t type = std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT;
    const std::vector<hsize_t> extent{values.size() / columns, columns};
    const Hdf5Handle space(H5Screate_simple(2, extent.data(), nullptr), H5Sclose);
    const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(links.get(), 1);
    Hdf5Handle table(H5Dcreate2(file, name.c_str(), type, space.get(), links.get(), H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    H5Dwrite(table.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    return table;
}

template <class T>
void putAttribute(hid_t object, const char* name, T value) {
    const hid_t type = std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT;
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle made(H5Acreate2(object, name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    H5Awrite(made.get(), type, &value);
}

void putStage(hid_t file, const MpcoStageRows& stage, std::size_t dimensions, const std::string& result) {
    const std::string group = "/MODEL_STAGE[" + std::to_string(stage.number) + "]";
    putTable(file, group + "/MODEL/NODES/ID", stage.nodes, 1);
    putTable(file, group + "/MODEL/NODES/COORDINATES", stage.places, dimensions);
    for (const MpcoClassRows& rows : stage.classes) {
        const Hdf5Handle table = putTable(file, group + "/MODEL/ELEMENTS/" + rows.name, rows.rows, rows.width);
        if (rows.geometry != 0) {
            putAttribute(table.get(), "GEOMETRY", rows.geometry);
        }
    }
    for (const auto& [element, area] : stage.fibres) {
        const std::string section = group + "/MODEL/SECTION_ASSIGNMENTS/SECTION_" + std::to_string(element) + "[Fiber]";
        putTable(file, section + "/ASSIGNMENT", std::vector<int>{element, 0, element, 1}, 2);
        putTable(file, section + "/FIBER_DATA", std::vector<double>{0.0, 0.0, 0.25 * area, 0.1, 0.0, 0.75 * area}, 3);
    }
    putTable(file, group + "/RESULTS/ON_NODES/" + result + "/ID", stage.nodes, 1);
    for (const auto& [step, time] : stage.states) {
        std::vector<double> moved(stage.places.size(), 0.0);
        for (std::size_t n = 0; n < stage.nodes.size(); ++n) {
            moved[n * dimensions] = 0.1 * step;
        }
        moved.resize(moved.size() - (step == stage.cutState ? dimensions : 0));
        const std::string name = group + "/RESULTS/ON_NODES/" + result + "/DATA/STEP_" + std::to_string(step);
        const Hdf5Handle table = putTable(file, name, moved, dimensions);
        putAttribute(table.get(), "STEP", step);
        putAttribute(table.get(), "TIME", time);
    }
    const Hdf5Handle handle(H5Gopen2(file, group.c_str(), H5P_DEFAULT), H5Gclose);
    putAttribute(handle.get(), "STEP", stage.states.empty() ? 0 : stage.states.front().first);
    putAttribute(handle.get(), "TIME", stage.states.empty() ? 0.0 : stage.states.front().second);
}

}  // namespace

void writeMpco(const std::string& path, const std::vector<MpcoStageRows>& stages, std::size_t dimensions,
               const std::string& result) {
    const Hdf5Session quiet;
    const Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    for (const MpcoStageRows& stage : stages) {
        putStage(file.get(), stage, dimensions, result);
    }
}

std::vector<MpcoStageRows> twoBricksMpco() {
    MpcoStageRows first;
    for (int n = 0; n < 12; ++n) {
        first.nodes.push_back(n + 1);
        first.places.insert(first.places.end(), {double(n % 3), double(n / 3 % 2), double(n / 6)});
    }
    first.classes = {{"56-Brick[400:0]", 9, {1, 1, 2, 5, 4, 7, 8, 11, 10, 2, 2, 3, 6, 5, 8, 9, 12, 11}, 400}};
    first.states = {{0, 0.0}, {1, 1.0}};
    MpcoStageRows second = first;
    second.number = 2;
    second.classes[0].rows.resize(9);
    second.states = {{2, 2.0}};
    return {first, second};
}

}  // namespace rubble::io
