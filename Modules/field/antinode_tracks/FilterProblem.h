#pragma once

#include "FingerFilters.h"

#include "PointResponses.h"
#include "TrackClimb.h"

#include <Eigen/Core>

namespace antinode
{
/** The samples of filters. */
struct FilterSpan
{
    Eigen::Index factor, delay, taps;
    Eigen::Index length; // of the transforms
    double rate;         // Hz
};

/** @throws InputError  for a latency or a rate that is not allowed [any] */
FilterSpan filterSpan (TrackBand, const FilterSettings&);

/** Errors count up to this frequency, Hz. [any] */
double highestWeighed (TrackBand);

/** Each line times how much an error counts there. [worker] */
void weighLines (PointResponses&, TrackBand);

/** An impulse after the delay, of which the lines that count are left: length. [worker] */
Eigen::VectorXd weighedImpulse (const FilterSpan&, TrackBand);

/** ||reached - wanted|| / ||wanted|| of a filter: what gradients have left, and what the compliance leaves. [worker] */
double filterError (const GradientsResult&, double compliance, const Eigen::VectorXd& impulse);

/** Refuses points that move: their way is not known to a filter. @throws InputError  naming the first [any] */
void requireFixedPoints (const WaveformsDescription&);
} // namespace antinode
