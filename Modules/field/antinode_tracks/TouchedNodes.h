#pragma once

#include "PathShapes.h"
#include "WindowedResponses.h"

#include <antinode_model/ModalModel.h>

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** Few motions whose sums, weighted from sample to sample, are those of the touched points wherever they move: for a
    point that stays its own motion; for one that moves what the singular vectors of the shapes along its path say, to
    1e-5 of the largest motion. Docs/Theory.md, section 4.13. */
class TouchedNodes
{
public:
    /** @param sampleRate  of the design, Hz: modes up to half of it may resonate
        @throws InputError  as requirePlaces, and when something moves and the modes are complex
        [worker] */
    TouchedNodes (const ModalModel&, const WaveformsDescription&, double sampleRate);

    /** In place of mode shapes at points: nodes x N_m, kg^-1/2. [any] */
    const Eigen::MatrixXd& shapes() const { return nodes; }

    /** How the nodes make the points at all samples of a design.
        @param lead   samples before the trigger
        @return       empty where nothing moves
        [worker] */
    MovingPoints weights (double sampleRate, Eigen::Index lead, Eigen::Index length) const;

    /** How many places the preconditioner of a design takes as fixed; one where nothing moves. [any] */
    std::size_t stages() const { return stageTimes.size(); }

private:
    std::vector<PathShapes> paths;
    std::vector<Eigen::MatrixXd> fits; // of each point: N_m x its nodes; empty of one that stays
    std::vector<Eigen::Index> points;  // of each node: its point
    std::vector<double> stageTimes;    // s after the trigger
    Eigen::MatrixXd nodes;
};
} // namespace antinode
