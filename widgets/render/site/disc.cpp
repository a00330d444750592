#include "widgets/render/site/disc.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <numbers>

namespace rubble::render {

void makeDisc(vtkPolyData& disc, const Vec3& centre, double unit, std::span<const double> rings,
              const std::function<std::array<std::uint8_t, 4>(double ring)>& colour) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> rgba;
    rgba->SetNumberOfComponents(4);
    const auto add = [&](double x, double y, double ring) {
        points->InsertNextPoint(x, y, centre.z());
        rgba->InsertNextTypedTuple(colour(ring).data());
    };
    add(centre.x(), centre.y(), 0.0);
    for (const double ring : rings) {
        for (int s = 0; s < sectors; ++s) {
            const double angle = 2.0 * std::numbers::pi * s / sectors;
            add(centre.x() + unit * ring * std::cos(angle), centre.y() + unit * ring * std::sin(angle), ring);
        }
    }
    for (int s = 0; s < sectors; ++s) {
        const vtkIdType next = (s + 1) % sectors;
        const std::array<vtkIdType, 3> first{0, 1 + s, 1 + next};
        cells->InsertNextCell(3, first.data());
        for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
            const vtkIdType inner = 1 + static_cast<vtkIdType>(r) * sectors;
            const vtkIdType outer = inner + sectors;
            const std::array<vtkIdType, 4> quad{inner + s, outer + s, outer + next, inner + next};
            cells->InsertNextCell(4, quad.data());
        }
    }
    disc.SetPoints(points);
    disc.SetPolys(cells);
    disc.GetPointData()->SetScalars(rgba);
    disc.Modified();
}

}  // namespace rubble::render
