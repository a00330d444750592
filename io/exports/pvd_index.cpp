#include "io/exports/pvd_index.h"

#include <array>
#include <charconv>
#include <pugixml.hpp>

#include "io/base/files.h"

namespace rubble::io {

namespace {

std::string timeText(double time) {
    std::array<char, 40> buffer{};
    return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), time).ptr};
}

}  // namespace

void writePvdIndex(const std::string& path, const std::vector<PvdEntry>& entries) {
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    pugi::xml_node file = document.append_child("VTKFile");
    file.append_attribute("type") = "Collection";
    file.append_attribute("version") = "0.1";
    pugi::xml_node collection = file.append_child("Collection");
    for (const PvdEntry& entry : entries) {
        pugi::xml_node set = collection.append_child("DataSet");
        set.append_attribute("timestep") = timeText(entry.time).c_str();
        set.append_attribute("part") = entry.part;
        if (!entry.name.empty()) {
            set.append_attribute("name") = entry.name.c_str();
        }
        set.append_attribute("file") = entry.file.c_str();
    }
    writeAtomically(path, [&](std::ostream& out) { document.save(out, "  "); });
}

}  // namespace rubble::io
