#pragma once

#include "FeltOutcome.h"
#include "PlayedTracks.h"
#include "PowerFlow.h"
#include "WaveformsTolerance.h"

#include <antinode_engine/LagFilters.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_tracks/TrackDesign.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** Waveforms at fingers, designed, played and judged. */
struct PerformedWaveforms
{
    ModalModel judge; ///< The surface that plays, with its fingers on it.
    TrackDesign design;
    PlayedTracks played;
    TrackScores scores;
    FeltOutcome felt;                          ///< Its targets are the touched points, those with tracks first.
    FocusPower power;                          ///< On the surface without fingers; repeated: one play after the other.
    std::optional<TrackCorrection> correction; ///< Where recorded passes were given.
    std::optional<UndoneLags> undone; ///< What is asked for so that ceramics get the designed voltages, where they lag.
    std::vector<double> expected; ///< dB: TrackScores::suppression of each finger to expect on the device itself; empty
                                  ///< where nobody estimated it.
    std::optional<WaveformsTolerance> tolerance; ///< Where it was asked for.
    std::optional<double> likeness; ///< Of voltages from elsewhere: how alike reached and wanted motions are, -1 to 1.
};

/** Designs waveforms for one model of a surface, plays them on another one, and scores what comes of it. With a latency
   in the settings the voltages follow the tracks by filters that could run live.
    @param known  what the design knows
    @param judge  the same surface without fingers, with more modes
    @param passes  played and recorded before, in their order: the design corrects the best of them
    @throws InputError, Cancelled  as designTracks and correctionFrom
    [worker] Docs/Theory.md, sections 4.13 and 5.3. */
PerformedWaveforms performWaveforms (const ModalModel& known, const ModalModel& judge, const WaveformsDescription&,
                                     const TrackSettings&, const ShowProgress& progress = {},
                                     const std::vector<RecordedPass>& passes = {});

/** Plays designed waveforms on a surface, without fingers, and scores what comes of it. [worker] */
PerformedWaveforms performDesigned (const ModalModel& judge, TrackDesign, const SkinThreshold&);

/** What voltages do that come from elsewhere, as from a recording of what a host played: they are played and scored as
   those of a design. When their tracks begin is found: at the whole sample where the reached motion is most like the
   wanted one.
    @param known     what says which motion is wanted
    @param judge     as performWaveforms
    @param voltages  N_b x N_s, V, at the rate of the settings
    @throws InputError  for another number of ceramics, points that move, more than memory holds
    @throws Cancelled   when a watch of this thread says no
    [worker] */
PerformedWaveforms judgeVoltages (const ModalModel& known, const ModalModel& judge, const WaveformsDescription&,
                                  const TrackSettings&, const Eigen::MatrixXd& voltages,
                                  const ShowProgress& progress = {});

/** What files and outputs get, N_b x N_s, V: the designed voltages, or what is asked for so that ceramics get them.
   [any] */
const Eigen::MatrixXd& outputVoltages (const PerformedWaveforms&);

/** A touched point by its own name, or as a file numbers it. @param point  index in touchedPoints [any] */
std::string fingerName (const WaveformsDescription&, std::size_t point);

/** What the voltages need of their limits, in one sentence. [any] */
std::string trackVoltsInWords (const PerformedWaveforms&);

/** As summary.json has it. [any] Docs/FileFormats.md. */
nlohmann::ordered_json performedToJson (const PerformedWaveforms&);

/** Waveforms at fingers as a design that can be written and played as a focus is. Its trigger is the first sample; its
    target is the fastest motion that any track wants, at its finger; the fingers rest on the surface, and whoever
    designs the target again does not know of them.
    @param own  the device's own modes, without fingers
    @throws InputError  where a track is longer than a focus may be
    [worker] Docs/Design/tracks.md */
FocusDesign performedDesign (const PerformedWaveforms&, const ModalModel& own);
} // namespace antinode
