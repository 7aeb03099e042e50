#include "ResumableTolerance.h"

#include "PartFolder.h"

#include <antinode_documents/DesignFile.h>
#include <antinode_documents/FieldStream.h>

#include <nlohmann/json.hpp>

#include <vector>

namespace antinode
{
namespace
{
/** Of all that the draws depend on. */
std::string hashOfStudy (const ModalModel& model, FocusDesign design, const ToleranceOptions& options)
{
    design.certificate.milliseconds = 0; // of the solver: another one each time
    const auto& [spread, draws, seed] = options;
    FieldWriter writer;
    writer (model, designToJson (design, model).dump(), design.truncatedField, spread.frequency, spread.damping,
            spread.participation, spread.drift, draws, seed);
    return hashOf (std::move (writer.bytes));
}

CaseResult resultOf (const FocusScore& score)
{
    return { { score.vScore, score.fieldError, score.peakRatio }, {} };
}

std::vector<FocusScore> readDraws (const PartFolder& folder)
{
    std::vector<FocusScore> draws;

    for (std::size_t part = 0; part < folder.parts().size(); ++part)
        for (const auto& result : folder.read (part))
        {
            FocusScore score;
            score.vScore = result.values.at (0);
            score.fieldError = result.values.at (1);
            score.peakRatio = result.values.at (2);
            draws.push_back (score);
        }

    return draws;
}
} // namespace

Tolerance resumableTolerance (const std::filesystem::path& path, const ModalModel& model, const FocusDesign& design,
                              const ToleranceOptions& options, const std::function<void (double)>& progress)
{
    const ToleranceStudy study (model, design, options);
    const auto hash = hashOfStudy (model, design, options);
    const PartFolder folder (path / hash, hash, static_cast<std::uint64_t> (options.draws));
    const auto missing = folder.missing ({});
    const auto all = static_cast<double> (folder.casesOf (missing));
    computeParts ([&] (std::uint64_t number) { return resultOf (study.draw (number)); }, folder, missing,
                  processorThreads(), [&] (std::uint64_t done) { progress (static_cast<double> (done) / all); });
    return study.summary (readDraws (folder));
}
} // namespace antinode
