#pragma once

#include "Waveforms.h"

#include <antinode_model/ModalModel.h>

#include <Eigen/Core>

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
} // namespace antinode
