#pragma once

#include "PlayedTracks.h"

#include <antinode_tracks/Waveforms.h>

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** What one finger gets, of what it should and of what it should not. */
struct FingerScore
{
    double wantedPeak = 0, reachedPeak = 0; ///< m
    double wantedRms = 0;                   ///< m, within the band, of the whole event.
    double errorRms = 0;                    ///< m, within the band: of reached minus wanted.
    double wideErrorRms = 0;                ///< m, of all frequencies.
};

/** Scores of waveforms at points. */
struct TrackScores
{
    std::vector<FingerScore> fingers; ///< Those with tracks first.
    double strongestRms = 0;          ///< m, within the band, of the strongest track.

    /** What a finger should not feel over the strongest track, within the band or with all frequencies, dB. */
    double suppression (std::size_t finger) const;
    double wideSuppression (std::size_t finger) const;

    /** Energy of the error over that of the wanted waveform, within the band; of fingers with a track. */
    double normalisedError (std::size_t finger) const;
};

/** Compares played with wanted motion. The band is cut out sharply, over the whole event with its ringing.
    @param wanted  N_s x points, m, at the rate of what was played, from the trigger on
    [worker] Docs/Theory.md, section 5.3. */
TrackScores scoreTracks (const PlayedTracks&, const Eigen::MatrixXd& wanted, TrackBand band);
} // namespace antinode
