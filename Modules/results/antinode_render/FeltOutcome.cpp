#include "FeltOutcome.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <antinode_fingers/Sensation.h>
#include <antinode_focus/PeakSearch.h>
#include <antinode_numerics/DenseKernels.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double plateDensity = 0.35, lineDensity = 1; // places per point of the surface along each axis
constexpr Eigen::Index placesAtOnce = 64;

/** The levels of places, given by their mode shapes. */
std::vector<double> levelsOf (const Eigen::MatrixXd& shapes, const FeltMotion& motion)
{
    std::vector<double> levels;

    for (Eigen::Index begin = 0; begin < shapes.rows(); begin += placesAtOnce)
    {
        checkWatch();
        const auto count = std::min (placesAtOnce, shapes.rows() - begin);
        Eigen::MatrixXd weighted = Eigen::MatrixXd::Zero (count, motion.modal.cols());
        addProduct (weighted, 1, shapes.middleRows (begin, count), motion.modal);

        for (Eigen::Index i = 0; i < count; ++i)
            levels.push_back (sensationLevel (feltAmount (weighted.row (i), motion.sampleRate)));
    }

    return levels;
}

void lookEverywhere (FeltOutcome& outcome, const ModalModel& model, const FeltMotion& motion)
{
    const auto isLine = model.surface.kind == SurfaceKind::line;
    const auto search = searchPlaces (model, isLine ? lineDensity : plateDensity, {});
    const auto levels = levelsOf (search.shapes, motion);

    for (std::size_t i = 0; i < levels.size(); ++i)
        outcome.places.push_back ({ search.starts[i].at.x, search.starts[i].at.y, levels[i] });

    if (isLine || (model.surface.grid && ! model.surface.boundary))
        outcome.columns = std::count_if (outcome.places.begin(), outcome.places.end(),
                                         [&] (const auto& place) { return place.y == outcome.places.front().y; });

    const auto evenly = levels.end() - static_cast<std::ptrdiff_t> (search.alongBoundary);
    const auto felt = std::count_if (levels.begin(), evenly, [] (double level) { return level > 0; });
    outcome.feltShare = static_cast<double> (felt) / static_cast<double> (evenly - levels.begin());
}

bool isFar (const FeltPlace& place, const std::vector<Target>& targets)
{
    return std::all_of (targets.begin(), targets.end(),
                        [&] (const Target& target)
                        { return std::hypot (place.x - target.x, place.y - target.y) > feltNeighbourhood; });
}

std::string placeInWords (const Surface& surface, const FeltPlace& place)
{
    return fixedText (place.x * milli, 1)
           + (surface.kind == SurfaceKind::line ? "" : ", " + fixedText (place.y * milli, 1)) + " mm";
}

std::string decibels (double level)
{
    return fixedText (level, 1) + " dB";
}
} // namespace

std::optional<double> FeltOutcome::contrast() const
{
    return elsewhere ? contrastTo (elsewhere->level) : std::nullopt;
}

std::optional<double> FeltOutcome::contrastTo (double level) const
{
    if (targets.empty())
        return {};

    const auto weakest = std::min_element (targets.begin(), targets.end(),
                                           [] (const auto& a, const auto& b) { return a.level < b.level; });
    return weakest->level - level;
}

FeltOutcome feltOutcome (const ModalModel& model, const Render& render, const std::vector<Target>& targets,
                         const SkinThreshold& threshold, const std::vector<std::pair<double, double>>& bystanders)
{
    const auto motion = feltMotion (model, render.modalVelocities, render.sampleRate, threshold);
    const auto feltAt = [&] (double x, double y) {
        return FeltPlace { x, y, levelsOf (shapesAt (model, x, y), motion).front() };
    };
    FeltOutcome outcome;
    outcome.threshold = threshold.source;

    for (const auto& target : targets)
        outcome.targets.push_back (feltAt (target.x, target.y));

    for (const auto& [x, y] : bystanders)
        outcome.bystanders.push_back (feltAt (x, y));

    lookEverywhere (outcome, model, motion);

    for (const auto& place : outcome.places)
        if (isFar (place, targets) && (! outcome.elsewhere || place.level > outcome.elsewhere->level))
            outcome.elsewhere = place;

    return outcome;
}

std::string feltInWords (const Surface& surface, const FeltOutcome& outcome)
{
    std::string text;

    for (const auto& target : outcome.targets)
        text += (text.empty() ? "" : ", ") + decibels (target.level);

    if (! text.empty())
        text += " over threshold at the focus; ";

    const auto beyond = fixedText (feltNeighbourhood * milli, 0) + " mm from it";

    for (const auto& place : outcome.bystanders)
        text += decibels (place.level) + " at " + placeInWords (surface, place) + "; ";

    if (! outcome.elsewhere)
        return text + "the surface ends within " + beyond;

    const auto& place = *outcome.elsewhere;
    return text + decibels (place.level) + " farther than " + beyond + ", at " + placeInWords (surface, place);
}

nlohmann::ordered_json feltToJson (const FeltOutcome& outcome)
{
    const auto placeJson = [] (const FeltPlace& place)
    {
        return nlohmann::ordered_json { { "place_mm", { place.x * milli, place.y * milli } },
                                        { "level_dB", place.level } };
    };
    nlohmann::ordered_json json { { "threshold", outcome.threshold }, { "targets", nlohmann::ordered_json::array() } };

    for (const auto& target : outcome.targets)
        json["targets"].push_back (placeJson (target));

    if (! outcome.bystanders.empty())
        json["bystanders"] = nlohmann::ordered_json::array();

    for (const auto& place : outcome.bystanders)
    {
        json["bystanders"].push_back (placeJson (place));

        if (const auto contrast = outcome.contrastTo (place.level))
            json["bystanders"].back()["contrast_dB"] = *contrast;
    }

    json["elsewhere"] = outcome.elsewhere ? placeJson (*outcome.elsewhere) : nlohmann::ordered_json();
    json["contrast_dB"] = outcome.contrast() ? nlohmann::ordered_json (*outcome.contrast()) : nlohmann::ordered_json();
    json["felt_share"] = outcome.feltShare;
    return json;
}
} // namespace antinode
