#include "tests/io/fe/med/med_builder.h"

#include <algorithm>
#include <set>
#include <stdexcept>

// libmed may be built for parallel HDF5 and then names MPI in functions that are not called here.
struct ompi_communicator_t;
struct ompi_info_t;
using MPI_Comm = ompi_communicator_t*;
using MPI_Info = ompi_info_t*;
#include <med.h>

namespace rubble::io {

namespace {

constexpr const char* meshName = "mesh";

void require(bool written, const std::string& what) {
    if (!written) {
        throw std::runtime_error("MED file not written: " + what);
    }
}

std::string padded(const std::vector<std::string>& names, std::size_t width) {
    std::string text;
    for (std::string name : names) {
        name.resize(width, ' ');
        text += name;
    }
    return text;
}

void putMesh(med_idt file, const MedRows& rows) {
    const std::string axes = padded({"X", "Y", "Z"}, MED_SNAME_SIZE), units = padded({"m", "m", "m"}, MED_SNAME_SIZE);
    require(MEDmeshCr(file, meshName, rows.dimensions, rows.dimensions, MED_UNSTRUCTURED_MESH, "small", "s", MED_SORT_DTIT,
                      MED_CARTESIAN, axes.c_str(), units.c_str()) >= 0,
            "mesh");
    const auto nodes = static_cast<med_int>(rows.places.size() / static_cast<std::size_t>(rows.dimensions));
    require(MEDmeshNodeCoordinateWr(file, meshName, MED_NO_DT, MED_NO_IT, 0.0, MED_FULL_INTERLACE, nodes, rows.places.data()) >= 0,
            "nodes");
    require(MEDfamilyCr(file, meshName, "FAMILLE_ZERO", 0, 0, "") >= 0, "family 0");
    for (const auto& [number, groups] : rows.groups) {
        const std::string name = "FAM_" + std::to_string(number);
        require(MEDfamilyCr(file, meshName, name.c_str(), number, static_cast<med_int>(groups.size()),
                            padded(groups, MED_LNAME_SIZE).c_str()) >= 0,
                name);
    }
    for (const MedBlockRows& block : rows.blocks) {
        const auto count = static_cast<med_int>(block.nodes.size()) / (block.type % 100);
        require(MEDmeshElementConnectivityWr(file, meshName, MED_NO_DT, MED_NO_IT, 0.0, MED_CELL, block.type, MED_NODAL,
                                             MED_FULL_INTERLACE, count, block.nodes.data()) >= 0,
                "cells");
        if (!block.numbers.empty()) {
            MEDmeshEntityNumberWr(file, meshName, MED_NO_DT, MED_NO_IT, MED_CELL, block.type, count, block.numbers.data());
        }
        if (!block.families.empty()) {
            MEDmeshEntityFamilyNumberWr(file, meshName, MED_NO_DT, MED_NO_IT, MED_CELL, block.type, count, block.families.data());
        }
    }
}

void putValues(med_idt file, const MedRows& rows, const MedFieldRows& field, const std::string& profile) {
    const med_entity_type entity = field.type == 0 ? MED_NODE : field.onCellNodes ? MED_NODE_ELEMENT : MED_CELL;
    std::size_t count = rows.places.size() / static_cast<std::size_t>(rows.dimensions);
    for (const MedBlockRows& block : rows.blocks) {
        if (field.type == block.type) {
            count = block.nodes.size() / static_cast<std::size_t>(block.type % 100);
        }
    }
    require(MEDfieldValueWithProfileWr(
                file, field.name.c_str(), field.step, field.step, field.time, entity, field.type == 0 ? MED_NONE : field.type,
                MED_COMPACT_STMODE, profile.empty() ? MED_NO_PROFILE : profile.c_str(), MED_NO_LOCALIZATION, MED_FULL_INTERLACE,
                MED_ALL_CONSTITUENT, static_cast<med_int>(count), reinterpret_cast<const unsigned char*>(field.values.data())) >= 0,
            field.name);
}

}  // namespace

void writeMed(const std::string& path, const MedRows& rows) {
    const med_idt file = MEDfileOpen(path.c_str(), MED_ACC_CREAT);
    require(file >= 0, path);
    putMesh(file, rows);
    std::set<std::string> made;
    std::map<std::vector<int>, std::string> profiles;
    for (const MedFieldRows& field : rows.fields) {
        if (made.insert(field.name).second) {
            const std::string names = padded(field.components, MED_SNAME_SIZE), units(names.size(), ' ');
            require(MEDfieldCr(file, field.name.c_str(), MED_FLOAT64, static_cast<med_int>(field.components.size()), names.c_str(),
                               units.c_str(), "s", meshName) >= 0,
                    field.name);
        }
        std::string& profile = profiles[field.profile];
        if (profile.empty() && !field.profile.empty()) {
            profile = "PROFILE_" + std::to_string(profiles.size());
            MEDprofileWr(file, profile.c_str(), static_cast<med_int>(field.profile.size()), field.profile.data());
        }
        putValues(file, rows, field, profile);
    }
    MEDfileClose(file);
}

void touchMed(const std::string& path) {
    const med_idt file = MEDfileOpen(path.c_str(), MED_ACC_RDONLY);
    if (file >= 0) {
        med_bool changed = MED_FALSE, moved = MED_FALSE;
        MEDmeshnEntity(file, meshName, MED_NO_DT, MED_NO_IT, MED_NODE, MED_NO_GEOTYPE, MED_COORDINATE, MED_NO_CMODE, &changed,
                       &moved);
        MEDnMesh(file);
        MEDfileClose(file);
    }
}

MedRows twoBricksMed() {
    MedRows rows;
    for (int n = 0; n < 12; ++n) {
        rows.places.insert(rows.places.end(), {double(n % 3), double(n / 3 % 2), double(n / 6)});
    }
    // MED counts the first face the other way round.
    rows.blocks = {{204, {1, 4, 10, 7, 3, 6, 12, 9}, {1, 2}, {-3, -3}},
                   {308, {1, 4, 5, 2, 7, 10, 11, 8, 2, 5, 6, 3, 8, 11, 12, 9}, {3, 4}, {-1, -2}}};
    rows.groups = {{-1, {"PIER"}}, {-2, {"DECK"}}, {-3, {"LOAD", "ENDS"}}};
    for (int k = 0; k < 3; ++k) {
        std::vector<double> moved;
        for (int n = 0; n < 12; ++n) {
            moved.insert(moved.end(), {0.1 * k, 0.0, 0.0});
        }
        rows.fields.push_back({"RESU____DEPL", {"DX", "DY", "DZ"}, k, double(k), 0, {}, moved, false});
        const bool gone = k == 2;
        rows.fields.push_back({"RESU____SIEF_ELNO",
                               {"SIXX"},
                               k,
                               double(k),
                               308,
                               gone ? std::vector<int>{1} : std::vector<int>{},
                               std::vector<double>(gone ? 8 : 16, 5.0),
                               true});
    }
    return rows;
}

}  // namespace rubble::io
