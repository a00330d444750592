#include "io/fe/bodies/body_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

#include "core/base/error.h"
#include "core/fe/loose_bodies.h"
#include "io/fe/bodies/bodies_reader.h"
#include "io/fe/fe_reader.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {

namespace {

using testing::HasSubstr;

class BodyTableFile : public testing::Test {
protected:
    std::string lay(const std::string& text) {
        std::ofstream(m_folder / "bodies.csv") << text;
        return m_folder / "bodies.csv";
    }
    BodyTable read(const std::string& text) { return readBodyTable(lay(text)); }
    /// The error that reading gives: what and remedy.
    std::string refusal(const std::string& text) {
        try {
            read(text);
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("bodies.csv"));
            EXPECT_FALSE(error.remedy().empty());
            return englishText(error.message()) + " | " + englishText(error.remedy());
        }
        return "";
    }

    TemporaryFolder m_folder;
    const std::string m_plain = "mass_kg,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m";
};

TEST_F(BodyTableFile, UnitsOfTheHeadingAreTaken) {
    const BodyTable table = read(
        "id;mass_t;side_x_cm;side_y_mm;side_z_ft;x_km;y_m;z_in;vx_km_h;vy_m_s;vz_cm_s;wx_world_deg_s;wy_world_deg_s;wz_world_deg_s;"
        "time_ms;material\n"
        "a;0,3;50;600;1;0,1;2;100;36;-2;50;180;0;0;250;stone\n");
    ASSERT_EQ(table.bodies.size(), 1u);
    const LooseBody& body = table.bodies.front();
    EXPECT_DOUBLE_EQ(body.mass, 300.0);
    EXPECT_TRUE(body.sides.isApprox(Vec3(0.5, 0.6, 0.3048)));
    EXPECT_TRUE(body.pose.position.isApprox(Vec3(100.0, 2.0, 2.54)));
    EXPECT_TRUE(body.velocity.isApprox(Vec3(10.0, -2.0, 0.5)));
    EXPECT_TRUE(body.spin.isApprox(Vec3(std::numbers::pi, 0.0, 0.0)));
    EXPECT_DOUBLE_EQ(body.time, 0.25);
    EXPECT_EQ(body.material, Material::Stone);
    EXPECT_EQ(table.findings.count("bodies.along_axes"), 1);
    EXPECT_EQ(table.findings.count("bodies.at_rest"), 0);
}

TEST_F(BodyTableFile, SpinAboutTheAxesOfTheBodyIsTurned) {
    const BodyTable table =
        read(m_plain + ",roll_deg,pitch_deg,yaw_deg,wx_body_rad_s,wy_body_rad_s,wz_body_rad_s\n" + "10,1,1,1,0,0,5,0,0,90,2,0,0\n");
    EXPECT_TRUE(table.bodies.front().spin.isApprox(Vec3(0.0, 2.0, 0.0), 1e-12));
    EXPECT_TRUE(table.spins && table.turned);
}

TEST_F(BodyTableFile, WhatIsAssumedIsCounted) {
    const BodyTable table = read(m_plain + ",colour\n2400,1,1,1,0,0,5,red\n2400,1,1,1,3,0,5,blue\n");
    for (const char* id : {"bodies.at_rest", "bodies.without_spin", "bodies.along_axes", "bodies.material_guessed"}) {
        EXPECT_EQ(table.findings.count(id), 2) << id;
    }
    EXPECT_EQ(table.findings.count("bodies.column_unknown"), 1);
    EXPECT_EQ(table.bodies[1].id, "2");
}

TEST_F(BodyTableFile, NonsenseIsNamedWithItsLine) {
    EXPECT_THAT(refusal("mass,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m\n1,1,1,1,0,0,5\n"), HasSubstr("mass has no unit"));
    EXPECT_THAT(refusal("mass_kg,side_x_inch,side_y_m,side_z_m,x_m,y_m,z_m\n1,1,1,1,0,0,5\n"), HasSubstr("m, cm, mm"));
    EXPECT_THAT(refusal(m_plain + "\n1,1,1,1,0,0,5\n\n0,1,1,1,0,0,5\n"), HasSubstr("line 4 has 0"));
    EXPECT_THAT(refusal(m_plain + "\n1,1,-1,1,0,0,5\n"), HasSubstr("side_y"));
    EXPECT_THAT(refusal(m_plain + "\n1,1,1,1,0,x,5\n"), HasSubstr("no number"));
    EXPECT_THAT(refusal(m_plain + "\n1,1,1,1,0\n"), HasSubstr("no number"));
    EXPECT_THAT(refusal(m_plain + ",wx_rad_s,wy_rad_s,wz_rad_s\n1,1,1,1,0,0,5,1,1,1\n"),
                HasSubstr("wx_world_rad_s or wx_body_rad_s"));
    EXPECT_THAT(refusal(m_plain + ",wx_body_rad_s,wy_body_rad_s,wz_body_rad_s,wx_world_rad_s,wy_world_rad_s,wz_world_rad_s\n"
                                  "1,1,1,1,0,0,5,1,1,1,1,1,1\n"),
                HasSubstr("of the table and about those of the body"));
    EXPECT_THAT(refusal(m_plain + ",qw,qx,qy,qz\n1,1,1,1,0,0,5,1,1,0,0\n"), HasSubstr("no rotation"));
    EXPECT_THAT(refusal(m_plain + ",qw,qx,qy\n1,1,1,1,0,0,5,1,0,0\n"), HasSubstr("no column qz"));
    EXPECT_THAT(refusal("mass_kg,side_x_m,side_y_m,side_z_m,x_m,y_m\n1,1,1,1,0,0\n"), HasSubstr("no column z"));
    EXPECT_THAT(refusal(m_plain + ",material\n1,1,1,1,0,0,5,cheese\n"), HasSubstr("cheese"));
    EXPECT_THAT(refusal(m_plain + ",material\n1,1,1,1,0,0,5,soil\n"), HasSubstr("soil"));
    EXPECT_THAT(refusal("id," + m_plain + "\na,1,1,1,1,0,0,5\na,1,1,1,1,0,0,5\n"), HasSubstr("as line 2"));
    EXPECT_THAT(refusal("mass_g," + m_plain + "\n1,1,1,1,1,0,0,5\n"), HasSubstr("stands twice"));
    EXPECT_THAT(refusal(m_plain + "\n"), HasSubstr("no bodies"));
    EXPECT_EQ(read("mass_t,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m\n2400,1,1,1,0,0,5\n").findings.count("bodies.density"), 1);
}

TEST_F(BodyTableFile, OpensAsAResult) {
    const std::string path =
        lay("# let go by hand\nid," + m_plain + ",time_s,material\n7,480,1,1,0.2,0,0,5,0.5,stone\n9,2400,1,1,1,3,0,5,0,\n");
    const auto fe = openFe(path, {}, {}, Execution{});
    EXPECT_EQ(fe->contents().format, "Table of bodies");
    EXPECT_EQ(fe->mesh().elementIds, (std::vector<std::int64_t>{7, 9}));
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 0.5, 0.6}));
    EXPECT_EQ(fe->mesh().parts[0].name, "stone");
    EXPECT_EQ(fe->mesh().parts[1].name, "concrete, by density");
    EXPECT_DOUBLE_EQ(fe->mesh().density[0], 2400.0);
    EXPECT_TRUE(fe->activity().active(1, idAt<ElementIndex>(0)));
    EXPECT_FALSE(fe->activity().active(1, idAt<ElementIndex>(1)));
    EXPECT_EQ(fe->activity().activeCount(2), 0u);
}

TEST_F(BodyTableFile, ABodyHasTheHullOfItsMesh) {
    // A wedge of 2 x 1 x 1 m, far from the origin: half of the box around it.
    std::ofstream(m_folder / "wedge.obj") << "v 10 0 0\nv 12 0 0\nv 12 1 0\nv 10 1 0\nv 10 0 1\nv 10 1 1\n"
                                             "f 1 4 3 2\nf 1 2 5\nf 4 6 3\nf 1 5 6 4\nf 2 3 6 5\n";
    const std::string path =
        lay("id,mass_kg,mesh,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m\n"
            "a,2400,wedge.obj,,,,0,0,5\n"
            "b,300,wedge.obj,1,0.5,0.5,3,0,5\n"
            "c,2400,,1,1,1,6,0,5\n");
    const BodyTable table = readBodyTable(path);
    ASSERT_EQ(table.bodies.size(), 3u);
    ASSERT_NE(table.bodies[0].hull, nullptr);
    EXPECT_NEAR(table.bodies[0].density(), 2400.0, 1e-6);
    EXPECT_NEAR(table.bodies[1].density(), 2400.0, 1e-6);
    EXPECT_TRUE(table.bodies[1].sides.isApprox(Vec3(1.0, 0.5, 0.5)));
    EXPECT_EQ(table.bodies[2].hull, nullptr);
    EXPECT_EQ(table.findings.count("bodies.mesh_hollow") + table.findings.count("bodies.mesh_open"), 0);
    EXPECT_EQ(table.findings.count("bodies.mesh_corners"), 0);
    const auto fe = openFe(path, {}, {}, Execution{});
    EXPECT_EQ(fe->contents().files, (std::vector<std::string>{path, m_folder / "wedge.obj"}));
    EXPECT_EQ(bodiesOfTable(*fe).back(), 2u);
    EXPECT_EQ(fe->mesh().elementCount(), 8u + 8u + 1u);
    // Another shape is another result.
    std::ofstream(m_folder / "wedge.obj", std::ios::app) << "v 12 0 1\nf 1 2 7\n";
    EXPECT_NE(openFe(path, {}, {}, Execution{})->contents().fingerprint, fe->contents().fingerprint);
}

TEST_F(BodyTableFile, AMeshThatIsNotConvexIsToldAndABadOneRefused) {
    // Two cubes of 1 m beside each other, 1 m apart: they fill two thirds of their hull.
    const std::string cube = "f %1 %4 %3 %2\nf %5 %6 %7 %8\nf %1 %2 %6 %5\nf %2 %3 %7 %6\nf %3 %4 %8 %7\nf %4 %1 %5 %8\n";
    std::string text;
    for (int k = 0; k < 2; ++k) {
        for (const char* corner : {"0 0", "1 0", "1 1", "0 1", "0 0 1", "1 0 1", "1 1 1", "0 1 1"}) {
            std::string place(corner);
            place[0] = static_cast<char>(place[0] + 2 * k);
            text += "v " + place + (place.size() == 3 ? " 0\n" : "\n");
        }
        std::string faces = cube;
        for (std::size_t at = faces.find('%'); at != std::string::npos; at = faces.find('%', at)) {
            faces.replace(at, 2, std::to_string(faces[at + 1] - '0' + 8 * k));
        }
        text += faces;
    }
    std::ofstream(m_folder / "two.obj") << text;
    std::ofstream(m_folder / "open.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n";
    std::ofstream(m_folder / "flat.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n";
    const std::string heading = "mass_kg,mesh,x_m,y_m,z_m\n";
    const BodyTable two = read(heading + "4800,two.obj,0,0,5\n");
    EXPECT_EQ(two.findings.count("bodies.mesh_hollow"), 1);
    EXPECT_NEAR(two.bodies.front().volume(), 3.0, 1e-9);
    EXPECT_EQ(read(heading + "240,open.obj,0,0,5\n").findings.count("bodies.mesh_open"), 1);
    EXPECT_THAT(refusal(heading + "1,flat.obj,0,0,5\n"), HasSubstr("no volume"));
    EXPECT_THAT(refusal(heading + "1,none.obj,0,0,5\n"), HasSubstr("line 2 names the mesh"));
    EXPECT_THAT(refusal(heading + "1,bodies.csv,0,0,5\n"), HasSubstr("no STL, OBJ or PLY"));
    EXPECT_THAT(refusal(heading + "1,,0,0,5\n"), HasSubstr("neither a mesh nor sides"));
    EXPECT_THAT(refusal("mass_kg,mesh,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m\n1,two.obj,1,,1,0,0,5\n"), HasSubstr("side_y"));
}

TEST_F(BodyTableFile, OtherTablesAreNone) {
    FileHead head;
    head.bytes = "element,time_s\n1,0.5\n";
    EXPECT_FALSE(recognisesBodies(head));
    head.bytes = "trajectory_id,mass_kg,radius_m\n";
    EXPECT_FALSE(recognisesBodies(head));
    head.bytes = "Mass,Side_X\n";
    EXPECT_TRUE(recognisesBodies(head));
}

}  // namespace

}  // namespace rubble::io
