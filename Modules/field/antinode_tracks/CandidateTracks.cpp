#include "CandidateTracks.h"

#include "TrackSolver.h"

namespace antinode
{
CandidateTracks::CandidateTracks (const ModalModel& model, const WaveformsDescription& description,
                                  const TrackSettings& settings)
    : problem (trackProblem (model, description, settings)), band (description.band),
      regularisation (settings.regularisation)
{
}

Eigen::MatrixXd CandidateTracks::voltages (const std::vector<Eigen::Index>& chosen) const
{
    const auto& all = problem.responses;
    PointResponses some { all.points, static_cast<Eigen::Index> (chosen.size()), all.length, all.sampleRate, {} };
    some.values.resize (all.values.rows(), some.points * some.actuators);

    for (Eigen::Index i = 0; i < some.actuators; ++i)
        some.values.middleCols (some.points * i, some.points) =
            all.values.middleCols (some.points * chosen[static_cast<std::size_t> (i)], some.points);

    const auto compliance = regularisation * regularisation * smallestResponse (some, problem.moving, band);
    constexpr std::size_t oneThread = 1; // choices are evaluated side by side
    WindowedResponses responses (std::move (some), problem.span.window, compliance, problem.moving, oneThread);
    return solveTracks (responses, problem.wanted).voltages;
}
} // namespace antinode
