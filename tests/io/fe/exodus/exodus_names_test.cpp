#include "io/fe/exodus/exodus_names.h"

#include <gtest/gtest.h>

namespace rubble::io {
namespace {

TEST(ExodusNames, TopologiesOfEveryFamilyAreKnownByTheirCorners) {
    const struct {
        const char* word;
        int nodes;
        ElementShape shape;
    } known[] = {{"HEX8", 8, ElementShape::Hexahedron},      {"hex", 8, ElementShape::Hexahedron},
                 {"HEX20", 20, ElementShape::Hexahedron},    {"HEX27", 27, ElementShape::Hexahedron},
                 {"WEDGE6", 6, ElementShape::Wedge},         {"WEDGE15", 15, ElementShape::Wedge},
                 {"TETRA", 4, ElementShape::Tetrahedron},    {"TET10", 10, ElementShape::Tetrahedron},
                 {"PYRAMID5", 5, ElementShape::Pyramid},     {"PYRAMID13", 13, ElementShape::Pyramid},
                 {"QUAD4", 4, ElementShape::Quadrilateral},  {"QUAD9", 9, ElementShape::Quadrilateral},
                 {"SHELL4", 4, ElementShape::Quadrilateral}, {"SHELL8", 8, ElementShape::Quadrilateral},
                 {"SHELL", 3, ElementShape::Triangle},       {"TRI3", 3, ElementShape::Triangle},
                 {"TRISHELL6", 6, ElementShape::Triangle},   {"BAR2", 2, ElementShape::Beam},
                 {"BEAM3", 3, ElementShape::Beam},           {"TRUSS", 2, ElementShape::Beam}};
    for (const auto& row : known) {
        EXPECT_EQ(shapeOf(row.word, row.nodes), row.shape) << row.word;
    }
    for (const char* word : {"SPHERE", "NSIDED", "nfaced", "NULL", "", "CIRCLE"}) {
        EXPECT_EQ(shapeOf(word, 8), std::nullopt) << word;
    }
    EXPECT_EQ(shapeOf("HEX8", 4), std::nullopt) << "too few nodes for its corners";
    EXPECT_EQ(shapeOf("SHELL", 2), std::nullopt);
}

TEST(ExodusNames, VectorsAreFoundInAnySpelling) {
    using Names = std::vector<std::string>;
    for (const Names& names : {Names{"disp_x", "disp_y", "disp_z"}, Names{"DISPLX", "DISPLY", "DISPLZ"},
                               Names{"displ_x", "displ_y", "displ_z"}, Names{"ux", "uy", "uz"}, Names{"U_x", "U_y", "U_z"},
                               Names{"Displacement_X", "Displacement_Y", "Displacement_Z"}, Names{"disp-x", "disp-y", "disp-z"}}) {
        const auto found = findDisplacement(names);
        ASSERT_TRUE(found) << names[0];
        EXPECT_EQ(found->index, (std::array<int, 3>{0, 1, 2}));
        EXPECT_FALSE(findVelocity(names)) << names[0];
    }
    for (const Names& names : {Names{"vel_x", "vel_y", "vel_z"}, Names{"VELX", "VELY", "VELZ"}, Names{"v_x", "v_y", "v_z"},
                               Names{"velocity_x", "velocity_y", "velocity_z"}}) {
        EXPECT_TRUE(findVelocity(names)) << names[0];
        EXPECT_FALSE(findDisplacement(names)) << names[0];
    }
    EXPECT_EQ(findDisplacement({"disp_z", "T", "disp_x", "disp_y"})->index, (std::array<int, 3>{2, 3, 0}));
    EXPECT_FALSE(findDisplacement({"disp_x", "disp_y"})) << "two components are no vector in space";
    EXPECT_FALSE(findDisplacement({}));
    EXPECT_EQ(findVector({"rot_x", "rot_y", "rot_z"}, "ROT")->name, "rot_x, rot_y, rot_z");
}

TEST(ExodusNames, FlagsByTheirConvention) {
    EXPECT_EQ(findStatus({"EQPS", "STATUS"}, "")->activeByName, 1);
    EXPECT_EQ(findStatus({"elem_status"}, "")->activeByName, 0);
    EXPECT_EQ(findStatus({"DEATH_STATUS"}, "")->activeByName, 1);
    EXPECT_EQ(findStatus({"EROSION"}, "")->activeByName, std::nullopt);
    EXPECT_EQ(findStatus({"stress", "status", "death_status"}, "")->name, "death_status") << "the surer name first";
    EXPECT_FALSE(findStatus({"Damage", "stress"}, "")) << "damage is a threshold for the user to set, not a deletion";
    EXPECT_EQ(findStatus({"Damage", "stress"}, "damage")->index, 0);
    EXPECT_EQ(findStatus({"Flag", "flag"}, "flag")->index, 1) << "the exact spelling wins";
    EXPECT_FALSE(findStatus({"STATUS"}, "other")) << "a named flag is not replaced by another";
}

TEST(ExodusNames, NamesCanAlwaysBeShown) {
    EXPECT_EQ(shownName("deck   "), "deck");
    EXPECT_EQ(shownName("Br\xc3\xbc"
                        "cke"),
              "Br\xc3\xbc"
              "cke");
    EXPECT_EQ(shownName("Br\xfc"
                        "cke\x01"),
              "Br?cke?");
    EXPECT_EQ(shownName("\xe2\x82"), "??") << "cut in the middle of a character";
    EXPECT_EQ(shownName("\xed\xa0\x80"), "???") << "a surrogate";
    EXPECT_EQ(shownName(""), "");
}

}  // namespace
}  // namespace rubble::io
