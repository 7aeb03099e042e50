#include "TableExport.h"

#include <antinode_base/Prefixes.h>
#include <antinode_text/CsvText.h>
#include <antinode_text/MatlabWriter.h>

namespace antinode
{
std::string encodeModeTable (const ModalModel& model)
{
    constexpr int significantDigits = 17;
    std::string text = "mode,frequency_Hz,damping_ratio,error_estimate_relative";
    const auto appendNumber = [&] (double value)
    {
        text += ',';
        appendCsvNumber (text, value, significantDigits);
    };

    for (const auto& ceramic : model.ceramics)
        text += ',' + csvField ("participation_" + ceramic.name + "_per_V");

    if (model.hasComplexModes())
        for (const auto& ceramic : model.ceramics)
            text += ',' + csvField ("participation_imaginary_" + ceramic.name + "_per_V");

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        text += '\n' + std::to_string (k + 1);
        appendNumber (model.frequencyHz (k));
        appendNumber (model.dampingRatios[k]);

        if (model.frequencyErrors.size() > 0)
            appendNumber (model.frequencyErrors[k]);
        else
            text += ',';

        for (Eigen::Index i = 0; i < model.actuators(); ++i)
            appendNumber (model.participation (k, i));

        if (model.hasComplexModes())
            for (Eigen::Index i = 0; i < model.actuators(); ++i)
                appendNumber (model.participation (model.modes() + k, i));
    }

    return text + '\n';
}

namespace
{
Eigen::MatrixXd number (double value)
{
    return Eigen::MatrixXd::Constant (1, 1, value);
}

/** A column of one number of each oscillation. */
template <typename Number>
Eigen::MatrixXd column (const std::vector<Oscillation>& oscillations, const Number& of)
{
    Eigen::MatrixXd values (static_cast<Eigen::Index> (oscillations.size()), 1);

    for (std::size_t i = 0; i < oscillations.size(); ++i)
        values (static_cast<Eigen::Index> (i), 0) = of (oscillations[i]);

    return values;
}

void addOscillations (std::vector<MatlabMatrix>& all, const std::vector<Oscillation>& drives)
{
    all.push_back ({ "mode", column (drives, [] (const auto& each) { return each.mode + 1; }), {} });
    all.push_back ({ "start_s", column (drives, [] (const auto& each) { return each.start; }), {} });
    all.push_back ({ "end_s", column (drives, [] (const auto& each) { return each.end; }), {} });
    all.push_back ({ "growth_per_s", column (drives, [] (const auto& each) { return each.growth; }), {} });
    all.push_back (
        { "angular_frequency_rad_s", column (drives, [] (const auto& each) { return each.angularFrequency; }), {} });
    all.push_back ({ "in_phase", column (drives, [] (const auto& each) { return each.inPhase; }), {} });
    all.push_back ({ "quadrature", column (drives, [] (const auto& each) { return each.quadrature; }), {} });
}
} // namespace

std::string encodeModesForMatlab (const ModalModel& model)
{
    const auto modes = model.modes();
    MatlabMatrix frequencies { "frequency_Hz", Eigen::MatrixXd (modes, 1), {} };

    for (Eigen::Index k = 0; k < modes; ++k)
        frequencies.real (k, 0) = model.frequencyHz (k);

    MatlabMatrix participation { "participation_per_V", model.participation.topRows (modes), {} };
    const auto on = pointsOn (model.surface);
    MatlabMatrix shapes { "shape", model.shapes (on, Eigen::all).leftCols (modes), {} };

    if (model.hasComplexModes())
    {
        participation.imaginary = model.participation.bottomRows (modes);
        shapes.imaginary = model.shapes (on, Eigen::all).rightCols (modes);
    }

    return encodeMatlabFile ({ frequencies,
                               { "damping_ratio", model.dampingRatios, {} },
                               participation,
                               shapes,
                               { "points_mm", model.surface.points (on, Eigen::all) * milli, {} },
                               { "mass_kg", model.surface.masses (on), {} } });
}

std::string encodeDesignForMatlab (const FocusDesign& design, const ModalModel& model)
{
    const auto& program = design.program;
    std::vector<MatlabMatrix> all { { "allocation_V", program.allocation, {} } };
    addOscillations (all, program.oscillations);

    if (program.samples)
    {
        all.push_back ({ "samples_V", program.samples->values, {} });
        all.push_back ({ "first_time_s", number (program.samples->firstTime), {} });
    }

    all.push_back ({ "sample_rate_Hz", number (design.playback.sampleRate), {} });
    all.push_back ({ "focus_time_s", number (program.focusTime), {} });
    all.push_back ({ "voltage_limits_V", program.voltageLimits, {} });
    const auto on = pointsOn (model.surface);
    all.push_back ({ "points_mm", model.surface.points (on, Eigen::all) * milli, {} });
    all.push_back ({ "wanted_mm_s", design.target.field (on) * milli, {} });
    all.push_back ({ "represented_mm_s", design.truncatedField (on) * milli, {} });
    return encodeMatlabFile (all);
}
} // namespace antinode
