#include "PlacementOutcomes.h"

#include "Perform.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/LimitUse.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_render/RenderedFocus.h>
#include <antinode_tracks/CandidateTracks.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace antinode
{
namespace
{
constexpr Playback playback { Reconstruction::bandLimited, 192000 };

/** A model of which nothing limits the drives. */
ModalModel unlimitedModel (const ModalModel& device)
{
    auto model = withoutVoltageLimits (device);

    for (auto& ceramic : model.ceramics)
        ceramic.slewLimit = 0;

    return model;
}

FocusDesign designUnlimited (const ModalModel& model, FocusDescription focus)
{
    focus.allocation.voltageLimit.reset();
    return designFocus (model, focus, playback, DesignExtent::playable);
}
} // namespace

std::vector<PlacementOutcome> placementOutcomes (const ModalModel& device, const std::vector<FocusDescription>& focuses)
{
    const auto model = unlimitedModel (device);
    std::vector<PlacementOutcome> outcomes;

    for (const auto& focus : focuses)
    {
        const auto rendered = renderFocus (model, designUnlimited (model, focus), { playback, {}, {} });
        outcomes.push_back ({ focus.name, rendered.render.voltages.cwiseAbs().maxCoeff(),
                              voltageLimits (device).maxCoeff(), rendered.score.fieldError, rendered.contrast });
    }

    return outcomes;
}

namespace
{
TrackSettings trackSettings()
{
    TrackSettings settings;
    settings.threshold = findSkinThreshold ({});
    return settings;
}

std::vector<std::pair<std::string, double>> worstNumbers (const std::vector<PlacementOutcome>& outcomes)
{
    PlacementOutcome worst { {}, 0, 0, 0, std::numeric_limits<double>::infinity() };

    for (const auto& each : outcomes)
    {
        worst.peakVoltage = std::max (worst.peakVoltage, each.peakVoltage);
        worst.limit = each.limit;
        worst.fieldError = std::max (worst.fieldError, each.fieldError);
        worst.contrast = std::min (worst.contrast, each.contrast);
    }

    return { { "peak_voltage_V", worst.peakVoltage },
             { "voltage_limit_V", worst.limit },
             { "field_error", worst.fieldError },
             { "contrast", worst.contrast } };
}
} // namespace

std::vector<std::pair<std::string, double>> placementNumbers (const PlaceRequest& request,
                                                              const DeviceDescription& device)
{
    if (! request.waveforms)
        return worstNumbers (placementOutcomes (solveStructure (device), request.focuses));

    constexpr auto usesCache = true; // Whoever plays the device that is written needs the same modes.
    const auto reached = performWithinLimits (trackModels (device, usesCache),
                                              placedWaveforms (*request.waveforms, request.at), trackSettings());
    auto numbers = summaryNumbers (performedToJson (reached.performed));
    numbers.emplace_back ("level_share_dB", 20 * std::log10 (reached.share));
    return numbers;
}

PlacementCostOf peakVoltageCost (const DeviceDescription& device, const std::vector<FocusDescription>& focuses)
{
    return [=] (const PlacementCandidates& candidates) -> PlacementCost
    {
        return [=, &candidates] (const std::vector<Eigen::Index>& chosen)
        {
            double highest = 0;

            try
            {
                const auto model =
                    unlimitedModel (solveStructure (withCeramics (device, chosenCeramics (candidates, chosen))));

                for (const auto& focus : focuses)
                    highest = std::max (highest, peakVoltage (designUnlimited (model, focus)));
            }
            catch (const InputError&)
            {
                return std::numeric_limits<double>::infinity(); // these ceramics cannot reach it
            }

            return highest;
        };
    };
}

namespace
{
/** The bare device with all candidates as its ceramics. */
ModalModel candidateModel (const DeviceDescription& device, const PlacementCandidates& candidates)
{
    auto model = solveStructure (withCeramics (device, {}), static_cast<int> (candidates.angularFrequencies.size()));
    model.angularFrequencies = candidates.angularFrequencies;
    model.dampingRatios = candidates.dampingRatios;
    model.participation = candidates.participation;
    model.ceramics.resize (candidates.ceramics.size());
    return model;
}

/** The integral of omega |U|^2, to a factor: what alike ceramics turn into heat. */
double heatOf (const Eigen::MatrixXd& voltages)
{
    const auto length = quickLength (static_cast<double> (voltages.rows()));
    double heat = 0;

    for (Eigen::Index i = 0; i < voltages.cols(); ++i)
    {
        const auto lines = forwardFourier (voltages.col (i), length);
        heat += Eigen::ArrayXd::LinSpaced (lines.size(), 0, 1).matrix().dot (lines.cwiseAbs2());
    }

    return heat;
}
} // namespace

PlacementCostOf waveformsCost (const PlaceRequest& request)
{
    const auto waveforms = placedWaveforms (request.waveforms.value(), request.at);
    const auto touched = touchedPoints (waveforms).size();

    if (static_cast<std::size_t> (request.count) < touched)
        throw InputError ("placement: number of ceramics", "is " + std::to_string (request.count)
                                                               + "; allowed: at least " + std::to_string (touched)
                                                               + ", one per touched point");

    return [=, isHeat = request.least == "energy", device = request.device] (const PlacementCandidates& candidates)
    {
        const auto tracks =
            std::make_shared<const CandidateTracks> (candidateModel (device, candidates), waveforms, trackSettings());
        return [=] (const std::vector<Eigen::Index>& chosen)
        {
            const auto voltages = tracks->voltages (chosen);
            return isHeat ? heatOf (voltages) : voltages.cwiseAbs().maxCoeff();
        };
    };
}
} // namespace antinode
