#include "PaperCases.h"

#include "PaperTables.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/Prediction.h>
#include <antinode_focus/Projection.h>
#include <antinode_library/Inputs.h>

#include <algorithm>
#include <string>

namespace antinode
{
namespace
{
constexpr double paperRate = 192000;      // Hz
constexpr double shownAftermath = 0.0025; // s after the focus: the tables look at the focus only

RenderedFocus renderCell (const ModalModel& model, FocusDescription description, AllocationMethod method)
{
    description.allocation.method = method;
    RenderOptions options;
    options.playback = { Reconstruction::bandLimited, paperRate };
    options.duration = description.focusTime + shownAftermath;
    return renderFocus (model, designFocus (model, description, options.playback), options);
}

double minimumNormPeak (const ModalModel& model, FocusDescription description, DriveKind drive,
                        std::optional<double> growth)
{
    description.allocation.method = AllocationMethod::minimumNorm;
    description.transients.drive = drive;

    if (growth)
        description.transients.growth = { *growth };

    return peakVoltage (designFocus (model, description, {}));
}

int modesNeeded (const ModalModel& model, const ProjectedTarget& target, double captured)
{
    for (int count = 1; count <= model.modes(); ++count)
    {
        ModeChoice choice;
        choice.count = count;

        if (selectModes (model, target, choice).captured >= captured)
            return count;
    }

    return 0;
}

PaperCell evaluateCell (const ModalModel& model, const FocusDescription& description, double capturedInPrint)
{
    PaperCell cell;
    cell.exact = renderCell (model, description, AllocationMethod::exact);
    cell.paper = renderCell (model, description, AllocationMethod::paper);
    cell.modesNeeded = modesNeeded (model, cell.exact.design.target, capturedInPrint);

    for (std::size_t i = 0; i < paperDetuning.size(); ++i)
        cell.detunedVScore[i] = medianDetunedVScore (model, cell.exact.design, paperDetuning[i], paperDraws);

    for (std::size_t i = 0; i < paperGrowths.size(); ++i)
        cell.drivePeaks[i] = { minimumNormPeak (model, description, DriveKind::paper, paperGrowths[i]),
                               minimumNormPeak (model, description, DriveKind::offsetFree, paperGrowths[i]) };

    return cell;
}
} // namespace

double medianDetunedVScore (const ModalModel& model, const FocusDesign& design, const DetuningLevel& level, int draws)
{
    std::vector<double> scores;

    for (int draw = 1; draw <= draws; ++draw)
    {
        const auto plate =
            detuned (model, { level.frequency, level.damping, level.participation }, static_cast<std::uint64_t> (draw));
        const auto states = predictStates (plate, design.program, design.program.focusTime);
        const Eigen::VectorXd field = model.shapes * modalVelocities (plate, states);
        scores.push_back (scoreField (model.surface, field, design.truncatedField).vScore);
    }

    const auto middle = scores.begin() + draws / 2;
    std::nth_element (scores.begin(), middle, scores.end());
    return *middle;
}

std::vector<PaperCell> evaluatePaperCells (const ModalModel& model, const ShowProgress& progress)
{
    std::vector<PaperCell> cells;
    constexpr auto total = paperTables.size() * 5;

    for (const auto& row : paperTables)
        for (std::size_t place = 0; place < row.captured.size(); ++place)
        {
            progress ("Reproducing the paper", static_cast<double> (cells.size()) / total);
            const auto name = "paper-" + std::string (row.key) + "-p" + std::to_string (place + 1);
            cells.push_back (evaluateCell (model, loadFocus (name, {}), row.captured[place]));
        }

    return cells;
}
} // namespace antinode
