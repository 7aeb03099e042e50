// How near foci by least voltage come to what any waveform needs, and what they leave in modes beyond the known ones:
// Docs/Design/allocation.md. `Scripts/bench voltage` runs it on all devices.
//
//     antinode_bound_scores device focus foci rate [key=value...]
//
// Foci at random places, seed 1, a tenth of the shorter side from the edges, designed as those of a bank of the
// plug-in. They are played on the plate model with as many modes as can be solved, to 5 times the highest known
// frequency.

#include <antinode_allocation/WaveformBound.h>
#include <antinode_documents/Inputs.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusPlaces.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_numerics/Statistics.h>
#include <antinode_session/DesignWorker.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>
#include <vector>

namespace
{
using namespace antinode;

constexpr Eigen::Index mostModesOfBound = 150;

struct Outcome
{
    double peak = 0, ofSamples = 0;         // over the bound of any waveform, and over what the samples prove
    double error = 0;                       // of the field, relative to the truncated one
    double beyondKnown = 0, beyondWide = 0; // of the field: in modes that no design knows, and that none looks at
    double cpu = 0;                         // s
};

double relative (const ModalModel& model, const Eigen::VectorXd& field, const Eigen::VectorXd& whole)
{
    const auto& areas = model.surface.areas;
    return std::sqrt (areas.dot (field.cwiseAbs2()) / areas.dot (whole.cwiseAbs2()));
}

/** What the plate did at the focus: sampled voltages, limiter, modes from sample to sample. */
Eigen::VectorXd played (const ModalModel& model, const FocusDesign& design)
{
    RenderSettings settings;
    settings.playback = design.playback;
    settings.duration = design.program.focusTime + 1e-3;
    settings.probeShapes.resize (0, model.modes());
    return renderOffline (model, design.program, settings).focusVelocities;
}

Outcome judged (const FocusDesign& design, const ModalModel& known, const WideModel& judge, Eigen::Index looked)
{
    const auto velocities = played (judge.model, design);
    const Eigen::VectorXd field = judge.model.shapes * velocities;
    const auto from = [&] (Eigen::Index first) -> Eigen::VectorXd
    {
        const auto count = judge.model.modes() - first;
        return judge.model.shapes.rightCols (count) * velocities.tail (count);
    };
    Outcome outcome;
    outcome.error = relative (judge.model, field - design.truncatedField, design.truncatedField);
    outcome.beyondKnown = relative (judge.model, from (judge.known), field);
    outcome.beyondWide = relative (judge.model, from (looked), field);
    outcome.ofSamples = peakVoltage (design) / design.minimumPeakVoltage;

    // The bound of many modes takes seconds a place; what the samples prove is lower, so the ratio to it is larger.
    if (known.modes() <= mostModesOfBound)
        outcome.peak = peakVoltage (design) / finishDesign (design, known, DesignExtent::complete).lowerBoundVoltage;
    else
        outcome.peak = outcome.ofSamples;

    return outcome;
}

std::string medianAndWorst (std::vector<double> values, double factor, const char* format)
{
    char text[2][32];
    std::snprintf (text[0], sizeof text[0], format, factor * median (values));
    std::snprintf (text[1], sizeof text[1], format, factor * *std::max_element (values.begin(), values.end()));
    return std::string (text[0]) + " / " + text[1];
}
} // namespace

int main (int count, char** arguments)
{
    const std::vector<std::string> given (arguments + 1, arguments + count);
    const auto description = loadDevice (given.at (0), {});
    std::vector<std::string> keys { "focus.allocation.method=least_voltage" };
    keys.insert (keys.end(), given.begin() + 4, given.end());
    const auto focus = loadFocus (given.at (1), keys);
    const Playback playback { Reconstruction::bandLimited, std::atof (given.at (3).c_str()) };
    const auto model = std::make_shared<const ModalModel> (solveDevice (description, {}, true));
    const auto highest = model->frequencyHz (model->modes() - 1);
    const auto wide = solveWide (description, *model, frequencyBeyond (*model, playback.sampleRate), true);
    const auto judge = solveWide (description, *model, std::min (5 * highest, 60 * playback.sampleRate), true);
    std::fprintf (stderr, "%s: %td modes to %.1f kHz, designs look at %td to %.1f kHz, judged by %td to %.1f kHz\n",
                  given[0].c_str(), model->modes(), highest / 1e3, wide.model.modes(), wide.highestFrequency() / 1e3,
                  judge.model.modes(), judge.highestFrequency() / 1e3);
    const auto& surface = model->surface;
    const auto width = surface.xMaximum - surface.xMinimum, height = surface.yMaximum - surface.yMinimum;
    const auto margin = 0.1 * (height > 0 ? std::min (width, height) : width);
    std::mt19937 generator (1);
    std::uniform_real_distribution<double> alongX (surface.xMinimum + margin, surface.xMaximum - margin),
        alongY (height > 0 ? surface.yMinimum + margin : 0, height > 0 ? surface.yMaximum - margin : 1e-9);
    PlaceDesigner designer;
    const DesignRequest request { model, focus, {}, {}, playback, [&] { return wide; } };
    designer.begin (request);
    designer.design (request, focus); // the focus at its own place comes first
    std::vector<double> peaks, ofSamples, errors, beyond, beyondWide, cpu;

    for (int i = 0; i < std::atoi (given.at (2).c_str()); ++i)
    {
        const auto x = alongX (generator), y = height > 0 ? alongY (generator) : 0;
        const auto begin = std::clock();
        const auto design = designer.design (request, movedTo (focus, x, y));
        cpu.push_back (static_cast<double> (std::clock() - begin) / CLOCKS_PER_SEC);
        const auto outcome = judged (design, *model, judge, wide.model.modes());
        peaks.push_back (outcome.peak);
        ofSamples.push_back (outcome.ofSamples);
        errors.push_back (outcome.error);
        beyond.push_back (outcome.beyondKnown);
        beyondWide.push_back (outcome.beyondWide);
        std::fprintf (stderr,
                      "%d: %.1f, %.1f mm, %.3g V, %.3f x, error %.3f %%, beyond %.3f %%, far beyond %.3f %%, %.0f ms\n",
                      i + 1, 1e3 * x, 1e3 * y, peakVoltage (design), outcome.peak, 100 * outcome.error,
                      100 * outcome.beyondKnown, 100 * outcome.beyondWide, 1e3 * cpu.back());
    }

    const auto above = std::count_if (errors.begin(), errors.end(), [] (double error) { return error > 0.002; });
    std::printf ("| %s, `%s` | %g kHz | %s | %s | %s | %s | %td | %s |\n", given[0].c_str(), given[1].c_str(),
                 playback.sampleRate / 1e3, medianAndWorst (peaks, 1, "%.2f").c_str(),
                 medianAndWorst (ofSamples, 1, "%.2f").c_str(), medianAndWorst (errors, 100, "%.3f").c_str(),
                 medianAndWorst (beyondWide, 100, "%.3f").c_str(), above, medianAndWorst (cpu, 1e3, "%.0f").c_str());
}
