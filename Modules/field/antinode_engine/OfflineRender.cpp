#include "OfflineRender.h"

#include "FocusBank.h"
#include "VoltageLimiter.h"
#include "VoltageSynthesiser.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr double lowestRate = 8e3, highestRate = 2e6;  // Hz
constexpr double longestDuration = 60;                 // s
constexpr double maximumMemory = 1024.0 * 1024 * 1024; // bytes

template <typename... Parts>
std::string text (const Parts&... parts)
{
    std::ostringstream stream;
    stream.precision (9); // 2000000 instead of 2e+06
    (stream << ... << parts);
    return stream.str();
}

void requireUsable (const RenderSettings& settings)
{
    const auto rate = settings.playback.sampleRate;

    if (! (rate >= lowestRate && rate <= highestRate))
        throw InputError ("sample rate", text ("is ", rate, " Hz; allowed: ", lowestRate, " to ", highestRate, " Hz"));

    if (! (settings.duration > 0 && settings.duration <= longestDuration))
        throw InputError ("duration",
                          text ("is ", settings.duration, " s; allowed: above 0 to ", longestDuration, " s"));

    if (settings.blockSize < 1)
        throw InputError ("block size", text ("is ", settings.blockSize, "; allowed: 1 or more"));
}

/** The number of samples in the duration, after checking that they fit into memory and include the focus. */
Eigen::Index countSamples (const RenderSettings& settings, Eigen::Index rows, std::int64_t focusSample)
{
    const auto count = std::max (1.0, std::round (settings.duration * settings.playback.sampleRate));
    const auto bytes = count * static_cast<double> (rows) * sizeof (double);

    if (bytes > maximumMemory)
        throw InputError ("duration", text ("needs ", std::ceil (bytes / (1024 * 1024)),
                                            " MiB at this sample rate; allowed: ", maximumMemory / (1024 * 1024),
                                            " MiB; take a shorter duration or a lower rate"));

    if (focusSample < 0 || static_cast<double> (focusSample) >= count)
        throw InputError ("duration", text ("is ", settings.duration, " s, which ends before the focus at ",
                                            static_cast<double> (focusSample) / settings.playback.sampleRate, " s"));

    return static_cast<Eigen::Index> (count);
}

/** Calls back after every 1 % of the work. */
class Progress
{
public:
    Progress (const std::function<void (double)>& callback, Eigen::Index whole) : call (callback), total (whole) {}

    void reached (Eigen::Index done)
    {
        const auto hundredth = 100 * done / total;

        if (call && hundredth != last)
        {
            last = hundredth;
            call (static_cast<double> (done) / static_cast<double> (total));
        }
    }

private:
    const std::function<void (double)>& call;
    Eigen::Index total, last = 0;
};

/** A program's own samples, from the sample on which the first of them falls. */
struct PlacedSamples
{
    Eigen::Index first = 0;
    Eigen::MatrixXd values;

    void addTo (Eigen::Index begin, Eigen::Ref<Eigen::MatrixXd> block) const
    {
        const auto from = std::max (begin, first);
        const auto to = std::min (begin + block.cols(), first + values.cols());

        if (from < to)
            block.middleCols (from - begin, to - from) += values.middleCols (from - first, to - from);
    }
};

PlacedSamples placedSamples (const VoltageProgram& program, Playback playback, std::int64_t focusSample)
{
    if (! program.samples)
        return {};

    return { firstOwnSample (program, playback, focusSample), program.samples->values };
}

/** What an event passes through, in this order. */
struct Kernels
{
    VoltageSynthesiser synthesiser;
    PlacedSamples samples;
    VoltageLimiter limiter;
    PlateModel plate;
};

/** Fills samples first .. first + count - 1 of the voltages, and as many modal velocities as that gives: they lag, so
   those before the first sample are dropped. */
void renderBlock (Kernels& kernels, Eigen::Index first, Eigen::Index count, Eigen::MatrixXd& voltages,
                  Eigen::MatrixXd& modalVelocities)
{
    Eigen::MatrixXd block (modalVelocities.rows(), count);
    kernels.synthesiser.process (first, voltages.middleCols (first, count));
    kernels.samples.addTo (first, voltages.middleCols (first, count));
    kernels.limiter.process (voltages.middleCols (first, count));
    checkWatch();
    kernels.plate.processModes (voltages.middleCols (first, count), block);

    const auto target = first - kernels.plate.latencySamples();
    const auto dropped = std::clamp<Eigen::Index> (-target, 0, count);
    const auto kept = count - dropped;

    if (kept > 0)
        modalVelocities.middleCols (target + dropped, kept) = block.rightCols (kept);
}

/** Fills a render whose voltages have, beyond its samples, as many more as the plate model lags. */
void renderAll (Kernels& kernels, int blockSize, Eigen::Index samples, const std::function<void (double)>& progress,
                Render& render)
{
    Progress report (progress, samples);

    for (Eigen::Index first = 0; first < samples; first += blockSize)
    {
        checkWatch();
        const auto count = std::min<Eigen::Index> (blockSize, samples - first);
        renderBlock (kernels, first, count, render.voltages, render.modalVelocities);
        report.reached (first + count);
    }

    render.limitedSamples = kernels.limiter.limitedSamples();

    checkWatch();
    // What the plate does at the end depends on the voltages a little beyond it.
    renderBlock (kernels, samples, render.voltages.cols() - samples, render.voltages, render.modalVelocities);
    render.voltages.conservativeResize (Eigen::NoChange, samples);
}
} // namespace

Render renderOffline (const ModalModel& model, const VoltageProgram& program, const RenderSettings& settings,
                      const std::function<void (double)>& progress)
{
    requireUsable (settings);

    if (program.allocation.rows() != model.actuators() || program.voltageLimits.size() != model.actuators())
        throw InputError ("voltage program",
                          "needs one row of the allocation and one limit for every ceramic of the device");

    VoltageSynthesiser synthesiser (program, settings.playback);
    auto ownSamples = placedSamples (program, settings.playback, synthesiser.focusSample());
    Kernels kernels { std::move (synthesiser), std::move (ownSamples), VoltageLimiter (program.voltageLimits),
                      PlateModel (model, settings.playback, settings.probeShapes) };

    checkWatch();
    Render render;
    const auto rows = model.actuators() + model.coordinates() + settings.probeShapes.rows();
    const auto samples = countSamples (settings, rows, kernels.synthesiser.focusSample());
    render.sampleRate = settings.playback.sampleRate;
    render.focusSample = kernels.synthesiser.focusSample();
    render.voltages.resize (model.actuators(), samples + kernels.plate.latencySamples());
    render.modalVelocities.resize (model.coordinates(), samples);
    renderAll (kernels, settings.blockSize, samples, progress, render);

    if (kernels.limiter.isMuted())
        throw InputError ("voltage program", "has voltages beyond double precision");

    checkWatch();
    render.probeVelocities = settings.probeShapes * render.modalVelocities;
    render.focusVelocities = render.modalVelocities.col (render.focusSample);
    return render;
}
} // namespace antinode
