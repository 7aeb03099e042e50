#include "FocusMap.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/FocusPlaces.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_focus/Prediction.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_focus/TargetField.h>
#include <antinode_model/RigidMotion.h>
#include <antinode_model/ShapeInterpolation.h>
#include <antinode_model/Surface.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_render/FeltOutcome.h>
#include <antinode_text/CsvText.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr std::size_t placesAtOnce = 16; // one product with the shapes for so many
} // namespace

FocusMap mapFocus (const WideModel& wide, const FocusDescription& focus, const MapOptions& options,
                   const std::function<void (int done, int all)>& show)
{
    if (! focus.fingers.empty())
        throw InputError ("focus: fingers", "rest on the surface; allowed in a map: none");

    FocusMap map;
    map.device = wide.model.name;
    map.focus = focus.name;
    map.voltageLimit = voltageLimits (wide.model).maxCoeff();

    if (focus.allocation.voltageLimit)
        map.voltageLimit = std::min (map.voltageLimit, *focus.allocation.voltageLimit);

    const auto& surface = wide.model.surface;
    const auto cells = squareCells (surface, options.places);
    map.columns = cells.columns;
    map.rows = cells.rows;
    map.xMinimum = surface.xMinimum;
    map.xMaximum = surface.xMaximum;
    map.yMinimum = surface.yMinimum;
    map.yMaximum = surface.yMaximum;
    const auto places = static_cast<std::size_t> (cells.centres.rows());
    map.places.resize (places);
    const PlaceMapper mapper (wide, focus, options);
    CaseCounter counter (
        [&] (std::uint64_t done)
        {
            if (show)
                show (static_cast<int> (done), static_cast<int> (places));
        });
    const auto mapSome = [&] (std::size_t batch)
    {
        const auto first = batch * placesAtOnce, last = std::min (first + placesAtOnce, places);
        auto some = mapper.mapped (
            cells.centres.middleRows (static_cast<Eigen::Index> (first), static_cast<Eigen::Index> (last - first)));
        std::move (some.begin(), some.end(), map.places.begin() + static_cast<std::ptrdiff_t> (first));
        counter.add (last - first);
    };
    parallelFor ((places + placesAtOnce - 1) / placesAtOnce, mapSome, options.threads);

    if (std::all_of (map.places.begin(), map.places.end(), [] (const auto& place) { return ! place.error.empty(); }))
        throw InputError ("map", "no place can be designed; the first error: " + map.places.front().error);

    return map;
}

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

namespace
{
constexpr double highestFelt = 3000; // Hz: modes above it add less than skin notices
constexpr int fewestModes = 24;

/** An axis with half as many places in each segment: enough for waves that are several times as long. */
GridAxis coarser (const GridAxis& axis)
{
    constexpr int fewest = 4;
    const auto segments = axis.first.size() - 1;
    const Eigen::VectorXi counts = axis.first.tail (segments) - axis.first.head (segments);
    return gridAxis (axis.edges, ((counts.array() + 1) / 2).max (fewest).matrix());
}

/** The same shapes on fewer points. */
ModalModel onCoarserGrid (ModalModel model)
{
    if (! model.surface.grid)
        return model;

    const auto fine = *model.surface.grid;
    const PlateGrid grid { coarser (fine.x), coarser (fine.y) };
    const auto rowsX = interpolationRows (fine.x, grid.x.places), rowsY = interpolationRows (fine.y, grid.y.places);
    Eigen::MatrixXd shapes (rowsX.rows() * rowsY.rows(), model.modes());

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const Eigen::Map<const Eigen::MatrixXd> shape (model.shapes.col (k).data(), rowsX.cols(), rowsY.cols());
        Eigen::Map<Eigen::MatrixXd> (shapes.col (k).data(), rowsX.rows(), rowsY.rows()) =
            rowsX * shape * rowsY.transpose();
    }

    model.shapes = std::move (shapes);
    placeOnGrid (model.surface, grid);
    return model;
}

} // namespace

ModalModel feltModes (const ModalModel& model)
{
    const auto highest = 2 * std::numbers::pi * highestFelt;
    const auto& frequencies = model.angularFrequencies;
    const auto count = std::upper_bound (frequencies.begin(), frequencies.end(), highest) - frequencies.begin();
    return onCoarserGrid (
        firstModes (model, std::max<Eigen::Index> (count, std::min<Eigen::Index> (fewestModes, model.modes()))));
}

nlohmann::ordered_json mapToJson (const FocusMap& map)
{
    const auto failed =
        std::count_if (map.places.begin(), map.places.end(), [] (const auto& place) { return ! place.error.empty(); });
    const auto shared =
        std::count_if (map.places.begin(), map.places.end(), [] (const auto& place) { return place.isShared; });
    nlohmann::ordered_json json { { "device", map.device },
                                  { "focus", map.focus },
                                  { "columns", map.columns },
                                  { "rows", map.rows },
                                  { "places", map.places.size() },
                                  { "failed", failed },
                                  { "shared", shared },
                                  { "voltage_limit_V", map.voltageLimit },
                                  { "x_mm", { map.xMinimum * milli, map.xMaximum * milli } },
                                  { "y_mm", { map.yMinimum * milli, map.yMaximum * milli } } };
    return json;
}

std::string mapToCsv (const FocusMap& map, const std::function<std::string (std::string)>& inWords)
{
    constexpr int digits = 9;
    std::string text = "x_mm,y_mm,modes_controlled,captured,v_score,field_error,peak_voltage_V,spill_over,"
                       "felt_contrast_dB,error\n";

    for (const auto& place : map.places)
    {
        appendCsvNumber (text, place.x * milli, digits);
        text += ',';
        appendCsvNumber (text, place.y * milli, digits);

        if (! place.error.empty())
        {
            text += ",,,,,,,," + csvField (inWords (place.error)) + "\n";
            continue;
        }

        text += "," + std::to_string (place.controlled);

        for (const auto value : { place.captured, place.vScore, place.fieldError, place.peakVoltage, place.spillOver })
        {
            text += ',';
            appendCsvNumber (text, value, digits);
        }

        text += ',';

        if (place.contrast)
            appendCsvNumber (text, *place.contrast, digits);

        text += ",\n";
    }

    return text;
}
} // namespace antinode
