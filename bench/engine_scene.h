#pragma once

#include <filesystem>
#include <functional>
#include <variant>
#include <vector>

#include "core/engine/world/forwarding_world.h"

namespace rubble::bench {

/// What a run asks of its engine, in the order in which it asks: enough to run the engine alone, or another one.
struct EngineScene {
    struct BodyEnters {
        NewBody body;
    };
    struct BodyLeaves {
        BodyId body;
    };
    struct PieceEnters {
        CollisionShape shape;
        Pose pose;
        Material material = Material::Concrete;
    };
    struct PieceLeaves {
        PieceId piece;
    };
    /// Where a piece is at the end of the next step.
    struct PieceMoves {
        PieceId piece;
        Pose pose;
    };
    /// Substeps of all steps from now on.
    struct Substeps {
        int count = 0;
    };
    struct Step {
        double dt = 0.0;  ///< s
    };
    using Call = std::variant<BodyEnters, BodyLeaves, PieceEnters, PieceLeaves, PieceMoves, Substeps, Step>;

    WorldSettings settings;  ///< on level ground or none; its threads and its way to cancel are not kept
    std::vector<Call> calls;

    /// s, of all steps.
    double seconds() const;
    /// The same without pieces of the structure.
    EngineScene withoutPieces() const;
    /// The same with so many substeps in all steps.
    EngineScene inSubsteps(int count) const;
    /// The same in equal steps, at least so many a second, that end whenever bodies or pieces enter or leave. Pieces go on where
    /// they were between two steps of the scene, from place to place in a straight line and at constant spin.
    EngineScene inSteps(double perSecond) const;
};

/// A world that notes what it is asked, as it hands it on. Hooks into substeps are not noted: effects are not the engine's.
class SceneRecorder : public ForwardingWorld {
public:
    /// @param scene  must outlive this; throws std::runtime_error if the settings have a terrain
    SceneRecorder(std::unique_ptr<RigidWorld> world, const WorldSettings& settings, EngineScene& scene);

    BodyId addBody(const NewBody& body) override;
    void removeBody(BodyId body) override;
    PieceId addPiece(const CollisionShape& shape, const Pose& pose, Material material,
                     std::span<const std::uint32_t> nodes) override;
    void removePiece(PieceId piece) override;
    void movePiece(PieceId piece, const Pose& atStepEnd) override;
    void setSubsteps(int substeps) override;
    void step(double dt) override;

private:
    EngineScene& m_scene;
};

/// Writes a scene as text, one call a line; numbers read back to the same bits. The first lines say what each word means.
/// Throws std::runtime_error with the reason, also for shapes with hulls.
void writeScene(const EngineScene& scene, const std::filesystem::path& file);
/// Throws std::runtime_error with the line.
EngineScene readScene(const std::filesystem::path& file);

}  // namespace rubble::bench
