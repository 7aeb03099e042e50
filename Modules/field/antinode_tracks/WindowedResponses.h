#pragma once

#include "PointResponses.h"

#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/ParallelFor.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <vector>

namespace antinode
{
/** Points that move: each is a sum of nodes, whose weights change from sample to sample. */
struct MovingPoints
{
    std::vector<Eigen::Index> points; ///< Of each node, ascending: the point that it is a part of.
    Eigen::MatrixXd weights;          ///< length x nodes
    std::vector<Eigen::Index> stages; ///< Samples, ascending: what is inverted is inverted as if points stayed there.
};

/** The responses of points that move, as if they stayed where they are at a sample. @param nodes  of the nodes [worker]
 */
PointResponses frozenResponses (const PointResponses& nodes, const MovingPoints&, Eigen::Index sample);

/** G: from voltages that are 0 outside a window to displacement at the points over the whole of an event, by Fourier
    transforms, never as a matrix. Signals are columns. One thread at a time calls; each call uses as many as it may. */
class WindowedResponses
{
public:
    /** @param window      samples that voltages may differ from 0, from the first on
        @param compliance  lambda of the preconditioner, m^2/V^2, above 0
        @param moving      where points move: the responses are those of their nodes; without nodes: of the points
        @param threads     at least 1
        [worker] */
    WindowedResponses (PointResponses, Eigen::Index window, double compliance, MovingPoints moving = {},
                       std::size_t threads = processorThreads());

    /** G u. @param voltages  window x actuators @return  length x points [worker] */
    Eigen::MatrixXd motion (const Eigen::MatrixXd& voltages);

    /** G' z. @param multipliers  length x points @return  window x actuators [worker] */
    Eigen::MatrixXd pulls (const Eigen::MatrixXd& multipliers);

    /** (H H^H + lambda)^-1 line by line: the inverse of G G' + lambda if the window were all of the event. Where points
        move, the sum of those of all stages, each between windows in time whose squares add to 1.
        @param right  length x points [worker] */
    Eigen::MatrixXd precondition (const Eigen::MatrixXd& right);

    /** Another lambda, above 0. [worker] */
    void setCompliance (double);

    Eigen::Index length() const { return responses.length; }
    Eigen::Index points() const { return moving.points.empty() ? responses.points : moving.points.back() + 1; }
    Eigen::Index actuators() const { return responses.actuators; }
    Eigen::Index windowLength() const { return window; }
    double compliance() const { return lambda; }

private:
    Eigen::MatrixXcd spectra (const Eigen::MatrixXd& signals);
    /** Signals, each line multiplied by a factor from each signal to each result and summed. rows of length. */
    template <typename Term>
    Eigen::MatrixXd combined (const Eigen::MatrixXd& signals, Eigen::Index count, Eigen::Index rows, const Term& term);
    void forEach (Eigen::Index count, const std::function<void (Eigen::Index, FourierTables&)>& work);

    Eigen::MatrixXd stageInverse (const Eigen::MatrixXd& right, const Eigen::MatrixXcd& inverse);
    std::vector<Eigen::MatrixXcd> stageInverses() const;

    PointResponses responses;
    MovingPoints moving;
    Eigen::Index window;
    double lambda;
    std::vector<std::unique_ptr<FourierTables>> tables; // of each thread
    std::vector<Eigen::MatrixXcd> inverses; // of each stage (length / 2 + 1) x points^2: column p + points q
};
} // namespace antinode
