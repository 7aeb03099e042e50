#include "PlaceMapper.h"

#include "FeltModes.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/BankPlaces.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_focus/Prediction.h>
#include <antinode_focus/TargetField.h>
#include <antinode_model/RigidMotion.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_render/FeltOutcome.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double aftermath = 0.025; // s that are played after the focus

/** The lowest usual rate at which the drives of a model can be played. */
double enoughRate (const ModalModel& known, double usual)
{
    constexpr double perPeriod = 2.5;

    for (const auto rate : { 48000.0, 96000.0 })
        if (rate >= perPeriod * known.frequencyHz (known.modes() - 1))
            return std::min (rate, usual);

    return usual;
}

bool isOnSurface (const Surface& surface, const Target& target)
{
    const auto isInX = target.x >= surface.xMinimum && target.x <= surface.xMaximum;
    return isInX
           && (surface.kind == SurfaceKind::line || (target.y >= surface.yMinimum && target.y <= surface.yMaximum));
}

void describe (MapPlace& place, const FocusDesign& design)
{
    place.controlled = static_cast<int> (design.controlledModes.size());
    place.captured = design.captured;
    place.peakVoltage = peakVoltage (design);
}

} // namespace

PlaceMapper::PlaceMapper (const WideModel& wideToUse, const FocusDescription& focusToUse,
                          const MapOptions& optionsToUse)
    : wide (wideToUse), focus (focusToUse), options (optionsToUse), known (firstModes (wide.model, wide.known)),
      felt (feltModes (known)), areas (wide.model.surface.areas / wide.model.surface.areas.sum()),
      means (wide.model.shapes.transpose() * areas)
{
    if (PlacedDesigns::suits (wide, focus))
        shared.emplace (wide, focus, options.playback);
}

std::vector<MapPlace> PlaceMapper::mapped (const Eigen::MatrixX2d& places) const
{
    std::vector<FocusDescription> focuses;
    focuses.reserve (static_cast<std::size_t> (places.rows()));

    for (Eigen::Index i = 0; i < places.rows(); ++i)
        focuses.push_back (movedTo (focus, places (i, 0), places (i, 1)));

    const auto projections = shared ? projected (focuses) : Projections {};
    std::vector<MapPlace> results;

    for (Eigen::Index i = 0; i < places.rows(); ++i)
    {
        checkWatch();
        auto& place = results.emplace_back();
        place.x = places (i, 0);
        place.y = places (i, 1);

        try
        {
            compute (place, focuses[static_cast<std::size_t> (i)], projections, i);
        }
        catch (const InputError& error)
        {
            place.error = error.what();
        }
    }

    return results;
}

PlaceMapper::Projections PlaceMapper::projected (const std::vector<FocusDescription>& focuses) const
{
    const auto& model = wide.model;
    const auto count = static_cast<Eigen::Index> (focuses.size());
    Projections result;
    result.fields.resize (model.points(), count);

    for (Eigen::Index i = 0; i < count; ++i)
        result.fields.col (i) =
            targetField (model.surface, focuses[static_cast<std::size_t> (i)].targets, focus.edgeWindow);

    Eigen::MatrixXd weighted (model.points(), 2 * count);
    weighted << model.surface.masses.asDiagonal() * result.fields, areas.asDiagonal() * result.fields;
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero (model.modes(), 2 * count);
    addTransposedLeft (sums, 1, model.shapes, weighted);
    result.byMass = sums.leftCols (count);
    result.byArea = sums.rightCols (count);
    return result;
}

void PlaceMapper::compute (MapPlace& place, const FocusDescription& moved, const Projections& projections,
                           Eigen::Index i) const
{
    for (const auto& target : moved.targets)
        if (! isOnSurface (wide.model.surface, target))
            throw InputError ("focus", "has a target outside the surface there");

    if (shared)
    {
        ProjectedTarget target;
        target.modalVelocities = projections.byMass.col (i).head (wide.known);
        target.rigidEnergy = rigidEnergy (wide.model, projections.fields.col (i), target.modalVelocities);
        target.energy = wide.model.surface.masses.dot (projections.fields.col (i).cwiseAbs2()) - target.rigidEnergy;

        if (! (target.energy > 0))
            throw InputError ("focus: targets", "give no velocity anywhere on the surface");

        if (const auto made = shared->design (target))
        {
            place.isShared = true;
            describe (place, made->design);
            score (place, made->velocities, projections, i);
            feel (place, made->design, moved);
            return;
        }
    }

    computeAlone (place, moved);
}

/** A design of its own, where nothing can be shared. */
void PlaceMapper::computeAlone (MapPlace& place, const FocusDescription& moved) const
{
    const auto design = designWithin (wide, moved, options.playback, DesignExtent::playable);
    const auto& model = wide.model;
    const auto time = design.moments.front().time;
    const auto velocities = modalVelocities (model, predictStates (model, design.program, time));
    const auto field = scoreField (model.surface, model.shapes * velocities, design.moments.front().target.field);
    describe (place, design);
    place.vScore = field.vScore;
    place.fieldError = field.fieldError;
    place.spillOver = spillOverShare (wide, velocities);
    feel (place, design, moved);
}

/** As scoreField, by the overlaps of shapes. Docs/Theory.md, section 5. */
void PlaceMapper::score (MapPlace& place, const Eigen::VectorXd& velocities, const Projections& projections,
                         Eigen::Index i) const
{
    const Eigen::MatrixXd& gram = shared->areaGram();
    const auto whole = wide.model.surface.areas.sum();
    const auto field = projections.fields.col (i);
    const auto mean = means.dot (velocities), wantedMean = areas.dot (field);
    const auto reached = velocities.dot (gram * velocities) / whole;
    const auto wanted = areas.dot (field.cwiseAbs2());
    const auto both = velocities.dot (projections.byArea.col (i));
    const auto deviations = std::sqrt ((reached - mean * mean) * (wanted - wantedMean * wantedMean));
    place.vScore = deviations > 0 ? (both - mean * wantedMean) / deviations : 0;
    place.fieldError = std::sqrt (std::max (0.0, reached - 2 * both + wanted) / wanted);
    const auto beyond = wide.model.modes() - wide.known;
    const auto outside = velocities.tail (beyond);
    place.spillOver = std::sqrt (outside.dot (gram.bottomRightCorner (beyond, beyond) * outside) / whole / reached);
}

/** Plays the modes that skin may feel, at a rate that is enough for the drives. */
void PlaceMapper::feel (MapPlace& place, const FocusDesign& design, const FocusDescription& moved) const
{
    if (! options.threshold)
        return;

    const auto time = design.moments.back().time;
    RenderSettings settings;
    settings.playback = { options.playback.reconstruction, design.program.samples
                                                               ? options.playback.sampleRate
                                                               : enoughRate (known, options.playback.sampleRate) };
    settings.duration = std::max (2 * time, time + aftermath);
    settings.probeShapes.resize (0, felt.modes());

    for (const auto& oscillation : design.program.oscillations)
        settings.duration = std::max (settings.duration, oscillation.end);

    const auto render = renderOffline (felt, design.program, settings);
    place.contrast = feltOutcome (felt, render, moved.targets, *options.threshold).contrast();
}
} // namespace antinode
