#pragma once

#include "ChainModes.h"

namespace antinode
{
/** The modal model of a chain's surface: frequencies, shapes, slopes, masses and participations. Points are those of
   Gauss and Lobatto on every element: as many as make the Gram matrix exact, and at least as many as make cubic Hermite
   interpolation between them right to 1e-7 of the largest amplitude, up to the given frequency. Each shape is positive
   where it first exceeds a tenth of its largest amplitude.
    @param chain             divided for the given frequency
    @param modes             of the chain; all of them are handed on
    @param degree            that they were computed with
    @param angularFrequency  the highest that is wanted, rad/s
    @param width             of the surface, m
    @param momentsPerVolt    kappa_b of each ceramic, N m / V
    @return  without names, damping, limits and error estimates
    [worker] Docs/Theory.md, sections 1.2 to 1.5; paper (23). */
ModalModel makeModel (const ElementChain& chain, const ChainModes& modes, int degree, double angularFrequency,
                      double width, const Eigen::VectorXd& momentsPerVolt);
} // namespace antinode
