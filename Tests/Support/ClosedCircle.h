#pragma once

#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_identification/Identification.h>
#include <antinode_identification/IdentifiedModel.h>
#include <antinode_measurement/SimulatedBench.h>
#include <antinode_measurement/SurfaceMeasurement.h>

namespace antinode::test
{
/** Measures a model at points on the simulated bench. @param points  N_p x 2, m */
inline SurfaceMeasurement measuredOnBench (const ModalModel& model, const Eigen::MatrixX2d& points,
                                           ExcitationSettings settings, const SimulatedBenchSettings& bench)
{
    settings.levels = Eigen::VectorXd::Constant (model.actuators(), 20);
    const auto excitation = makeExcitation (settings, settings.levels);
    std::vector<std::string> names;
    Eigen::MatrixXd shapes (points.rows(), model.modes());

    for (Eigen::Index p = 0; p < points.rows(); ++p)
        shapes.row (p) = shapesAt (model, points (p, 0), points (p, 1));

    for (const auto& ceramic : model.ceramics)
        names.push_back (ceramic.name);

    auto measurement = unmeasured (excitation, names, points);
    auto own = bench;
    own.sampleRate = settings.sampleRate;

    for (Eigen::Index ceramic = 0; ceramic < model.actuators(); ++ceramic)
    {
        const auto played = playedRun (excitation, ceramic, 1);
        own.seed = bench.seed + static_cast<std::uint64_t> (ceramic);
        place (measurement, ceramic, 0,
               analyseRun (excitation, ceramic,
                           simulateBench (model, shapes, played.topRows (model.actuators()),
                                          played.bottomRows (1).transpose(), own)));
    }

    measurement.responses.variances
        .clear(); // As the universal files that measure writes, which have no place for them.
    return measurement;
}

/** What becomes of a focus that is designed on a device as it was identified, and played on the device itself: scores
   of the field on the true device against what the identified device does under the same voltages, at the measured
   points. */
inline FocusScore closedCircle (const ModalModel& model, const IdentifiedModes& identified,
                                const FocusDescription& focus)
{
    const Playback playback { Reconstruction::bandLimited, 192000 };
    MappedSurface surface;
    surface.name = "identified";
    surface.ceramics = model.ceramics;
    const auto copy = toModalModel (identified, surface);
    const auto design = designFocus (copy, focus, playback, DesignExtent::playable);

    RenderSettings render;
    render.playback = playback;
    render.duration = focus.focusTime + 0.001;
    render.probeShapes = copy.shapes;
    const auto own = renderOffline (copy, design.program, render);
    const auto& points = copy.surface.points;
    render.probeShapes.resize (points.rows(), model.modes());

    for (Eigen::Index p = 0; p < points.rows(); ++p)
        render.probeShapes.row (p) = shapesAt (model, points (p, 0), points (p, 1));

    const auto real = renderOffline (model, design.program, render);
    const Eigen::VectorXd expected = own.probeVelocities.col (own.focusSample);
    const Eigen::VectorXd reached = real.probeVelocities.col (real.focusSample);
    Eigen::Index peak = 0;
    expected.cwiseAbs().maxCoeff (&peak);
    return { scoreField (copy.surface, reached, expected), reached[peak] / expected[peak] };
}
} // namespace antinode::test
