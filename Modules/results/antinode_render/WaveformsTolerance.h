#pragma once

#include <antinode_base/Progress.h>
#include <antinode_fingers/Sensation.h>
#include <antinode_focus/Tolerance.h>
#include <antinode_tracks/TrackDesign.h>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace antinode
{
/** What designed voltages do at the touched points of devices that deviate: a row per device, a column per point, those
    with tracks first. */
struct WaveformsTolerance
{
    ToleranceOptions options;
    Eigen::MatrixXd levels;      ///< dB over threshold.
    Eigen::MatrixXd suppression; ///< dB: TrackScores::suppression.
};

/** The voltages of a design on devices drawn around a surface, which answer linearly: by their responses at the touched
    points alone. A draw depends on its number alone, and is that of a tolerance study of foci.
    @param judge  without fingers
    @throws InputError  for complex modes, and as designTracks
    @throws Cancelled   when a watch of this thread says no
    [worker], on all cores. Docs/Theory.md, section 7.4. */
WaveformsTolerance waveformsTolerance (const ModalModel& judge, const TrackDesign&, const SkinThreshold&,
                                       const ToleranceOptions&, const ShowProgress& progress);

/** As summary.json has it: percentiles of each point. [any] Docs/FileFormats.md. */
nlohmann::ordered_json toleranceToJson (const WaveformsDescription&, const WaveformsTolerance&);

/** A line per device: levels, then unwanted motion of all points. [any] Docs/FileFormats.md. */
std::string toleranceToCsv (const WaveformsTolerance&);

/** The percentiles as lines of text. [any] */
std::string toleranceInWords (const WaveformsDescription&, const WaveformsTolerance&);
} // namespace antinode
