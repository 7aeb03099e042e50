#pragma once

#include "Node.h"

#include <Eigen/Core>
#include <antinode_engine/PlateModel.h>
#include <antinode_engine/RealtimePlate.h>

#include <atomic>
#include <memory>
#include <span>

namespace antinode
{
/** A node that moves a surface: voltages in, the velocity at each probe out. */
class SurfaceNode : public Node
{
public:
    /** Looks at other places from the next block on; the surface goes on moving.
        @param probeShapes  as many rows as before, kg^-1/2
        @throws InputError  when sizes do not agree
        [worker, one at a time, not during prepare] allocates */
    virtual void setProbes (Eigen::MatrixXd probeShapes) = 0;

    /** How the modes move just now. @param velocities  room for N_c, m/s kg^1/2 [audio thread, not before prepare] */
    virtual void modalVelocities (std::span<double> velocities) const = 0;
};

/** The plate under the voltages: the velocity at each probe, a channel each, for a monitor. */
class PlateNode : public SurfaceNode
{
public:
    /** @param probeShapes  N_probes x N_c: the rows of mode shapes at the probes (shapesAt), kg^-1/2 */
    PlateNode (std::shared_ptr<const ModalModel>, Eigen::MatrixXd probeShapes);
    ~PlateNode() override;
    PlateNode (const PlateNode&) = delete;
    PlateNode& operator= (const PlateNode&) = delete;

    std::string name() const override { return "Plate"; }
    int inputs() const override { return static_cast<int> (model->actuators()); }
    int outputs() const override { return static_cast<int> (probeShapes.rows()); }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override;

    /** @throws InputError  as RealtimePlate */
    void setProbes (Eigen::MatrixXd probeShapes) override;
    void modalVelocities (std::span<double> velocities) const override { plate->modalVelocities (velocities); }

private:
    RealtimePlate& newestPlate();

    std::shared_ptr<const ModalModel> model;
    Eigen::MatrixXd probeShapes;
    double sampleRate = 0;
    std::unique_ptr<RealtimePlate> plate;
    std::atomic<RealtimePlate*> next { nullptr }, replaced { nullptr }; ///< To the audio thread, and back to be freed.
};

/** The surface as a render has it: exact for the band-limited voltage that the samples stand for, and therefore 15
    samples late. What PlateNode does without this delay, and at a fraction of the cost, is a few parts in a
    thousand away. */
class PlateModelNode : public SurfaceNode
{
public:
    /** @param probeShapes  N_probes x N_c: the rows of mode shapes at the probes (shapesAt), kg^-1/2 */
    PlateModelNode (std::shared_ptr<const ModalModel>, Eigen::MatrixXd probeShapes);
    ~PlateModelNode() override;
    PlateModelNode (const PlateModelNode&) = delete;
    PlateModelNode& operator= (const PlateModelNode&) = delete;

    std::string name() const override { return "Surface"; }
    int inputs() const override { return static_cast<int> (model->actuators()); }
    int outputs() const override { return probes; }
    void prepare (const NodeFormat&) override;
    void process (const NodeBlock&) override;
    void reset() override { plate->reset(); }
    std::int64_t latencySamples() const override { return plate->latencySamples(); }
    void setProbes (Eigen::MatrixXd probeShapes) override;
    void modalVelocities (std::span<double> velocities) const override;

private:
    void takeProbes();

    std::shared_ptr<const ModalModel> model;
    int probes;
    std::unique_ptr<const Eigen::MatrixXd> shapes;
    std::unique_ptr<PlateModel> plate;
    Eigen::MatrixXd voltages, motion, heard; ///< Of one tile.
    std::atomic<const Eigen::MatrixXd*> next { nullptr },
        replaced { nullptr }; ///< To the audio thread, and back to be freed.
};
} // namespace antinode
