#pragma once

#include "Processor/PlayedProcessor.h"

#include <nlohmann/json.hpp>

#include <limits>
#include <map>
#include <string>
#include <utility>

namespace antinode::test
{
/** What a hosted plug-in must play for note 60 at its first sample. */
struct HostReference
{
    std::string state;        ///< As a host keeps it.
    Eigen::MatrixXd ceramics; ///< Row k: ceramic k as the command line renders it, in full scales.
    Eigen::MatrixXd
        monitors; ///< 2 x samples: velocities at the probes, m/s, as the processor plays them without a host.
};

/** A beam with 64 ceramics of 2 mm side by side, so that each wire up to the last carries another voltage. */
inline DeviceDocument combDevice()
{
    auto json = nlohmann::json::parse (R"({ "schema": "antinode.device/1", "name": "comb", "kind": "beam",
        "length_mm": 200, "width_mm": 15, "thickness_mm": 2, "material": "aluminium",
        "ends": { "left": "clamped", "right": "clamped" }, "quality_factor": 60,
        "limits": { "voltage_V": 150, "full_scale_V": 150 }, "modes": { "count": 30 } })");

    for (int i = 0; i < 64; ++i)
        json["ceramics"].push_back ({ { "x_mm", -94.6 + 3 * i },
                                      { "length_mm", 2 },
                                      { "width_mm", 10 },
                                      { "thickness_mm", 0.5 },
                                      { "material", "NCE51" },
                                      { "mounting", "both_sides" },
                                      { "wiring", "parallel" } });

    return readDeviceDocument (json, "device 'comb'");
}

inline FocusDocument combFocus()
{
    return readFocusDocument (
        nlohmann::json::parse (R"({ "schema": "antinode.focus/1", "name": "comb", "focus_time_ms": 25,
            "targets": [{ "shape": "bump", "x_mm": 23, "width_mm": 40, "peak_velocity_mm_s": 60 }],
            "probes_mm": [[23, 0], [-40, 0]] })"),
        "focus 'comb'");
}

inline HostReference referenceFor (const DeviceDocument& device, const FocusDocument& focus, double rate, int samples)
{
    const auto processor = offlineProcessor (64, rate, 512);
    processor->load (std::make_shared<const DeviceDocument> (device), std::make_shared<const FocusDocument> (focus));
    HostReference reference;
    reference.monitors = play (*processor, samples, 512, 0).bottomRows (2);
    reference.ceramics = renderedFocus (*processor->session().snapshot()->model, focus.description, rate, samples);
    juce::MemoryBlock state;
    processor->getStateInformation (state);
    reference.state = state.toString().toStdString();
    return reference;
}

/** Made once for all cases of a program. @param make  what is kept by rate and samples */
template <typename Make>
const HostReference& keptReference (double rate, int samples, const Make& make)
{
    static std::map<std::pair<double, int>, HostReference> known; // One for each kind of Make.
    const auto found = known.find ({ rate, samples });
    return found != known.end() ? found->second : known[{ rate, samples }] = make();
}

inline const HostReference& combReference (double rate, int samples)
{
    return keptReference (rate, samples, [&] { return referenceFor (combDevice(), combFocus(), rate, samples); });
}

inline const HostReference& demonstratorReference (double rate, int samples)
{
    return keptReference (rate, samples,
                          [&] { return referenceFor (*demonstrator().device, *demonstrator().focus, rate, samples); });
}

/** The largest difference of those two rows that are least apart. */
inline double leastDifference (const Eigen::MatrixXd& rows)
{
    auto least = std::numeric_limits<double>::infinity();

    for (Eigen::Index i = 0; i < rows.rows(); ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            least = std::min (least, (rows.row (i) - rows.row (j)).cwiseAbs().maxCoeff());

    return least;
}

/** How far what was played is from the reference: ceramics on the first wires, silence on those beyond the device's,
   then the monitors. @param noteAt  silence before it */
inline double deviation (const Eigen::MatrixXd& played, int ceramics, const HostReference& reference, int noteAt)
{
    const auto monitors = played.rows() - ceramics;
    const auto after = played.cols() - noteAt;
    const auto driven = std::min<Eigen::Index> (ceramics, reference.ceramics.rows());
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero (played.rows(), played.cols());
    expected.block (0, noteAt, driven, after) = reference.ceramics.block (0, 0, driven, after);
    expected.block (ceramics, noteAt, monitors, after) = reference.monitors.block (0, 0, monitors, after);
    return (played - expected).cwiseAbs().maxCoeff();
}

/** What a float wire may lose: half a unit in its last place, with room for the rounding of the way there. */
constexpr double wireTolerance = 1e-6;
} // namespace antinode::test
