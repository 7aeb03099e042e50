#pragma once

#include "Waveforms.h"
#include "WindowedResponses.h"

#include <Eigen/Core>
#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** The mode shapes of a touched point, wherever it is: computed every half millimetre of its path, polynomials of third
    order in between. */
class PathShapes
{
public:
    /** @param point  on the surface, as requirePlaces wants it [worker] */
    PathShapes (const ModalModel&, const TouchedPoint&);

    /** At how many places the shapes of a point are computed: what its table takes of memory. [any] */
    static Eigen::Index placesAlong (const TouchedPoint&);

    /** Whether the point has a path. [any] */
    bool moves() const { return ! legs.empty(); }

    /** Where the point is at a time: N_c, kg^-1/2. @param time  s after the trigger [worker] */
    Eigen::VectorXd at (double time) const;

    /** At all places that were computed: N_c x places, kg^-1/2. [any] */
    const Eigen::MatrixXd& places() const { return table; }

private:
    /** A straight line from one corner of the path to the next. */
    struct Leg
    {
        double begin = 0, end = 0; // s
        Eigen::Index first = 0, steps = 0;
    };

    static std::vector<Leg> legsOf (const TouchedPoint&);

    std::vector<Leg> legs;
    Eigen::MatrixXd table;
};

/** Those of all touched points. @throws InputError  as requirePlaces [worker] */
std::vector<PathShapes> pathShapes (const ModalModel&, const WaveformsDescription&);

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
