#include "widgets/figures/report/report_sections.h"

namespace rubble::figures {

void ReportSections::equation(const char* notation, const QString& words, const QString& where) {
    m_blocks.push_back(ReportEquation{QString::fromUtf8(notation), words, where});
}

void ReportSections::addMethod() {
    heading(tr("Method"));
    if (m_facts.fe->contents().looseBodies) {
        text(
            tr("There is no FE analysis: a table names bodies, and when and how each is let go. A physics engine carries them from "
               "there until they lie at rest. What is said of elements and fragments below holds for these bodies."));
    } else {
        text(tr(
            "A finite-element analysis of a collapse deactivates the elements that fail; from then on they are not part of it. "
            "Each "
            "deactivated element is turned into a rigid fragment with the place and shape it had when it was last active, and "
            "with its velocity then, unless that is said otherwise below. A "
            "physics engine carries the fragments from there until they lie at rest. The procedure follows Xu, Lu, Guan and Ren, "
            "Automation in Construction 35 (2013) 471–481, with the departures that are named below."));
    }
    addFragmentMethod();
    addGridMethod();
    addMotionMethod();
    addMeasureMethod();
}

void ReportSections::addFragmentMethod() {
    heading(tr("Fragments"), 2);
    text(
        tr("The mass of a fragment is the volume of its element at rest times the density of its component. Its velocity and its "
           "angular velocity conserve the momenta of the nodal velocity field over the last active shape of the element:"));
    equation(
        "m \\mathbf{v} = \\int_{V} \\rho \\mathbf{u} \\, dV \\quad \\quad I \\mathbf{ω} = \\int_{V} \\rho (\\mathbf{x} - "
        "\\mathbf{c}) \\times \\mathbf{u} \\, dV",
        tr("mass times velocity is the integral of density times nodal velocity; inertia times angular velocity is the integral of "
           "its moment"),
        tr("with the mass <i>m</i>, the inertia tensor <i>I</i> about the centre of mass <b>c</b>, the place <b>x</b>, the "
           "interpolated nodal velocity <b>u</b> and the density <i>ρ</i>, scaled so that its integral over the shape is "
           "<i>m</i>."));
    const bool bornAtRest = m_facts.scenario.fragments.birthVelocity == BirthVelocity::Rest;
    if (const double window = m_facts.scenario.fragments.birthWindow; window > 0.0) {
        text((bornAtRest
                  ? tr("In this run what died within %1 s of each other was handed over together, with the place and shape of "
                       "the first state of that time.")
                  : tr("In this run what died within %1 s of each other was handed over together, with the place, shape and "
                       "velocity of the first state of that time."))
                 .arg(reportNumber(window)));
    }
    if (bornAtRest) {
        text(
            tr("<b>In this run all debris began at rest</b>, not with the velocity that the FE result gave it: where it flew, it "
               "flies no longer."));
    }
}

void ReportSections::addGridMethod() {
    heading(tr("Clusters"), 2);
    text(
        tr("Fragments born together that move alike are carried by one rigid body, a cluster, so that the number of bodies stays "
           "within what a machine can simulate. The Basic Grid limits how far a cluster reaches along each axis. Between the mean "
           "distance <i>d</i> of fragments that are neighbours in their order along an axis and the grid size <i>h</i> stand"));
    equation(
        "d = \\frac{1}{N_{f} - 1} \\sum_{i} (z_{i+1}^{\\text{max}} - z_{i}^{\\text{min}}) \\quad \\quad h_{\\text{eff}} = d "
        "\\sqrt[3]{\\frac{N_{f}}{N_{A}}} \\quad \\quad h_{\\text{acc}} = \\max_{i} (z_{i}^{\\text{max}} - z_{i}^{\\text{min}})",
        tr("mean distance of adjacent fragments, the least grid size for efficiency, the least grid size for accuracy"),
        tr("with the number of fragments <i>N<sub>f</sub></i> and the largest number of bodies <i>N<sub>A</sub></i>; the smallest "
           "dimension of a structural component is the upper bound."));
    text(m_facts.scenario.grid.oneBodyPerFragment ? tr("In this run every fragment is a body of its own.")
         : m_facts.scenario.grid.grouping == Grouping::Nested
             ? tr("In this run clusters are made by nested cuts: the fragments of each component and birth are cut in two where "
                  "that "
                  "leaves the least spread, until every part is as compact as a full box of the grid that has the proportions of "
                  "its own "
                  "fragments.")
             : tr("In this run clusters are the product of groups along the three axes, as in the published method."));
}

void ReportSections::addMotionMethod() {
    heading(tr("Motion"), 2);
    text(
        tr("Bodies move by the equations of Newton and Euler under gravity, the contacts with each other, the ground and the "
           "structure "
           "that still stands, and the effects listed below:"));
    equation(
        "m \\frac{d\\mathbf{v}}{dt} = m \\mathbf{g} + \\sum_{k} \\mathbf{f}_{k} \\quad \\quad I \\frac{d\\mathbf{ω}}{dt} + "
        "\\mathbf{ω} \\times I \\mathbf{ω} = \\sum_{k} \\mathbf{r}_{k} \\times \\mathbf{f}_{k}",
        tr("mass times acceleration is weight plus contact forces; the change of angular momentum is the sum of their moments"),
        tr("with the contact forces <b>f</b><sub><i>k</i></sub> at the arms <b>r</b><sub><i>k</i></sub>. Tangential forces stay "
           "within Coulomb's cone with the friction of the pair of materials. The active structure follows the FE result and is "
           "not moved by the debris."));
}

void ReportSections::addMeasureMethod() {
    heading(tr("Measures"), 2);
    text(
        tr("Two fields of debris are compared by how their mass lies on the ground, by their outlines and by the way of each "
           "fragment:"));
    equation(
        "\\Delta M = \\frac{\\sum_{c} |m_{c} - m_{c}'|}{2 M} \\quad \\quad \\text{IoU} = \\frac{|A \\cap A'|}{|A \\cup A'|} "
        "\\quad \\quad r = \\frac{N^{*}}{N_{f}}",
        tr("mass-map difference, intersection over union of the footprints, accuracy rate"),
        tr("with the mass <i>m<sub>c</sub></i> in cell <i>c</i>, the total mass <i>M</i>, the footprints <i>A</i>, and the number "
           "<i>N</i><sup>*</sup> of fragments that lie within a tolerance of their place in the reference, in which every "
           "fragment is its own body."));
    text(
        tr("The run-out of the mass is the distance from the outline of what collapsed within which 95 % of the mass of the debris "
           "lies. "
           "The run-out of the area is what a survey can tell: the distance from the middle of the structure's plan within which "
           "95 % of the covered area of one direction lies."));
}

}  // namespace rubble::figures
