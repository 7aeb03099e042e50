#pragma once

#include "TrackWork.h"

#include <vector>

namespace antinode
{
/** What waveforms need of a few of many ceramics: the responses to all of them are computed once, so that a choice
   takes milliseconds. */
class CandidateTracks
{
public:
    /** @param model  whose ceramics are the candidates, which may overlap; their limits do not count
        @throws InputError  as designTracks
        [worker] */
    CandidateTracks (const ModalModel& model, const WaveformsDescription&, const TrackSettings&);

    /** The voltages of least norm with which some candidates move the points, as designTracks finds them without
       limits.
        @param chosen  at least as many as points
        @return        samples x chosen, V, at sampleRate()
        @throws Cancelled  when a watch of this thread says no
        [worker, several at once] */
    Eigen::MatrixXd voltages (const std::vector<Eigen::Index>& chosen) const;

    /** Of the voltages, Hz. [any] */
    double sampleRate() const { return problem.span.rate; }

private:
    TrackProblem problem;
    TrackBand band;
    double regularisation;
};
} // namespace antinode
