#include "LiveTracks.h"

#include "FilterPlayer.h"
#include "FingerFilters.h"

#include "TrackWork.h"
#include <antinode_base/MessageText.h>
#include <antinode_base/Watch.h>

#include <cmath>

namespace antinode
{
namespace
{
[[noreturn]] void throwTooLoud (double times)
{
    throw TrackLimitError ("waveforms",
                           "need " + inWords (times)
                               + " times the limits of the device; reachable: " + inWords (100 / times)
                               + " % of the wanted levels (" + fixedText (-20 * std::log10 (times), 1)
                               + " dB); more with a longer latency or fewer fingers",
                           1 / times, 1 / times);
}

/** What voltages and tracks take of the memory, as they are and transposed. */
TrackBytes liveBytes (const ModalModel& model, const WaveformsDescription& description, double sampleRate)
{
    constexpr double byNumber = sizeof (double), copies = 2;
    const auto signals = static_cast<double> (model.actuators()) + static_cast<double> (description.tracks.size())
                         + static_cast<double> (description.silent.size());
    return { byNumber * copies * signals * tracksDuration (description) * sampleRate, 0 };
}

/** Voltages until the last input has left the filters. */
Eigen::MatrixXd voltagesOf (const FilterBank& bank, const Eigen::MatrixXd& inputs)
{
    constexpr Eigen::Index noFade = 1, samplesPerLook = 256; // some ms of work at most
    FilterPlayer player (bank, noFade);
    const auto ringing = (bank.taps + 4 * rateChangeReach) * bank.factor;
    Eigen::MatrixXf voltages (bank.values.rows(), inputs.rows() + ringing);
    Eigen::VectorXf input = Eigen::VectorXf::Zero (bank.inputs);

    for (Eigen::Index n = 0; n < voltages.cols(); ++n)
    {
        if (n % samplesPerLook == 0)
            checkWatch();

        input = n < inputs.rows() ? Eigen::VectorXf (inputs.row (n).transpose().cast<float>())
                                  : Eigen::VectorXf::Zero (bank.inputs).eval();
        player.process (input, voltages.col (n));
    }

    return voltages.cast<double>();
}
} // namespace

TrackDesign designLiveTracks (const ModalModel& model, const WaveformsDescription& description,
                              const TrackSettings& settings, const ShowProgress& progress)
{
    requireTrackMemory (liveBytes (model, description, settings.sampleRate), tracksDuration (description));
    FilterSettings filterSettings;
    filterSettings.sampleRate = settings.sampleRate;
    filterSettings.latency = settings.latency;
    return liveTracks (model, description, settings,
                       designFingerFilters (model, description, filterSettings, progress));
}

TrackDesign liveTracks (const ModalModel& model, const WaveformsDescription& description, const TrackSettings& settings,
                        const FingerFilters& filters)
{
    TrackDesign design;
    design.description = description;
    design.wanted = wantedAsPlayed (model, description, settings);
    // Played earlier by the latency, so that the motion is where it is wanted.
    design.voltages = { { Reconstruction::bandLimited, settings.sampleRate },
                        -filters.latency(),
                        voltagesOf (filterBank (filters),
                                    design.wanted.leftCols (static_cast<Eigen::Index> (description.tracks.size()))) };
    design.designRate = filters.rate();
    design.latency = filters.latency();
    design.error = filters.error;
    design.iterations = filters.iterations;
    design.warnings = description.warnings;
    design.peaks = design.voltages.values.cwiseAbs().rowwise().maxCoeff();
    design.limitUse.unlimitedPeak = timesLimits (model, settings.sampleRate, design.voltages.values.transpose());

    if (design.limitUse.unlimitedPeak > 1)
        throwTooLoud (design.limitUse.unlimitedPeak);

    return design;
}
} // namespace antinode
