#pragma once

namespace rubble {

/// What is fixed in the simulation and nobody sets, with what each value endangers.

/// m/s. A hit on a frozen body faster than this thaws it. Lower: the pile wakes for every pebble; higher: hits are swallowed.
constexpr double thawSpeed = 1.0;
/// Share of the motion by position only, as soft contacts settle, that counts against a body's rest. Lower: it freezes while it
/// sinks; higher: towers lean before they freeze.
constexpr double settlingShare = 0.3;
/// Share of its smallest side that a body may lie in others and still count as settled.
constexpr double restingDepth = 0.02;
/// Share of its weight and of the load itself by which the load of a frozen body's contact may change before it thaws. Lower: piles
/// never sleep; higher: columns stand when their walls go.
constexpr double thawLoad = 0.5;
/// Part that one step has in the mean load of a contact. Lower: late; higher: piles wake for trembling.
constexpr double loadMemory = 0.1;
/// m. A thawed body that has moved this far thaws what it touched. Lower: piles never sleep; higher: blocks hang in the air.
constexpr double thawTravel = 0.005;
/// m/s. Deeper contact than the solver asks for is pushed apart at most this fast. Lower: piles squeeze; higher: they burst.
constexpr double separationSpeed = 2.0;
/// Share of its own smallest side that a newborn must be inside another solid to count as born in occupied space.
constexpr double occupiedShare = 0.05;
/// A piece that carries a body (from below) gives it per step at most this many times the impulse that would bring the free body
/// up to its own speed. Lower: piles are not lifted; higher: what is trapped between two solids is shot out.
constexpr double pieceCarryFactor = 3.0;
/// The same in each substep of the soft-step solver, which does not overshoot: enough for a pile on the piece.
constexpr double softCarryFactor = 20.0;
/// m/s2. What it may add to that for the load that lies on the body.
constexpr double carryAcceleration = 100.0;
/// m/s2. What a piece that closes in slowly from above or from the side may press with besides stopping that approach.
constexpr double nudgeAcceleration = 20.0;
/// It gives way when this many such pushes in a row left more than half of the closing speed: the body is trapped.
constexpr int piecePushes = 8;
/// m/s. A piece that strikes a body from above or from the side changes its speed by this much in all, then gives way: the FE
/// analysis never felt the body, and the elements of the piece bring their own momentum when they are born.
constexpr double piecePressSpeed = 0.5;
/// m/s. A piece that closes in on a body more slowly than this does not give way: it moves what touches it.
constexpr double pieceYieldSpeed = 1.0;
/// Upward part of the normal from which on a contact carries.
constexpr double carryingNormal = 0.5;
/// m. A contact point that cannot close in this step and is further apart than this is left out of the solve.
constexpr double inertGap = 0.02;
/// m. A piece of which no corner moves further than this in one FE interval stands still (files round coordinates to 1 mm).
constexpr double pieceStillTravel = 0.002;
/// m. Contacts are found this much before solids touch, plus the way they make in a step. Lower: contacts flicker; higher: slower.
constexpr double contactMargin = 0.01;
/// m. A point is left out of a step where it is further apart than this, g dt^2 and the way by which the fastest of its patch
/// closes by the motion that the two begin with. Lower: what trembles flickers, what strikes once more is met late; higher: slower.
constexpr double restingReach = 0.005;
/// m. Solids less deep in each other touch: that is no overlap to be brought apart. Higher: a push where they are born.
constexpr double touchingDepth = 1e-4;
/// Share of the smallest side that others may press a body into something; deeper, the two come apart by position like overlap at
/// birth. Lower: what carries its load trembles; higher: light bodies stay jammed in heavy ones.
constexpr double jammedDepth = 0.04;
/// s. Where whole spans fall on debris, two bodies that lie deeper in each other than that for so long are brought apart as well.
/// Lower: what is struck once is moved by position; higher: it stays squeezed.
constexpr double jamPatience = 0.05;
/// m in a step. Where overlap at birth pushes the lighter one of two bodies, or presses two together, less than this, contact alone
/// keeps them apart. Lower: columns that only touch stand too high; higher: more stays jammed.
constexpr double jammingPush = 0.002;
/// Way of a body in a step over that of one contact, at most, where many bring overlap at birth apart. Lower: deep piles stay
/// squeezed; higher: single bodies jump.
constexpr double correctionReach = 10.0;
/// m/s. Soft contacts push overlap apart at most this fast. Lower: piles squeeze; higher: they burst.
constexpr double pushOutSpeed = 1.0;
/// m/s. Hits slower than this do not bounce. Lower: piles tremble; higher: small bounces are lost.
constexpr double restitutionThreshold = 0.5;
/// Hz. Stiffness of a soft contact as an oscillator, at most; a quarter of the substep rate if that is less.
constexpr double contactFrequency = 30.0;
/// Share of the thinner body's smallest side by which its load may press a contact in. Lower: trembles; higher: thin plates vanish.
constexpr double sinkShare = 0.03;
/// m. Bodies with a smallest side below this are thin.
constexpr double thinSide = 0.1;
/// A step is halved further, at most this many times, as long as more than this share of the loaded contacts would sink in more.
constexpr double softShare = 0.02;
constexpr int mostDoublings = 2;
/// A contact point off the centre moves about this much less mass, times the share of the load it carries.
constexpr double pointShare = 2.0;
/// Upward part of a normal from which on the lower of two bodies supports the upper one.
constexpr double supportingNormal = 0.3;
/// m/s. A body faster than this does not stand on anything.
constexpr double standingSpeed = 0.3;
/// A body under one heavier by more than this counts as heavier in that contact while it stands on something. Lower: light bodies
/// pass on less of a blow; higher: heavy ones sink into them.
constexpr double mostMassRatio = 30.0;
/// m, s. A piece gives way to a body that has been this deep in it for so long. Lower: pieces carry less; higher: what is jammed
/// between a piece and the ground presses on its neighbours.
constexpr double jamDepth = 0.05;
constexpr double jamTime = 0.25;
/// m. Half the thickness of the ground box: more than any body is deep.
constexpr double groundHalfThickness = 50.0;
/// m. The ground reaches this far beyond the structure, or ten times its size, whichever is more.
constexpr double groundMargin = 1000.0;

}  // namespace rubble
