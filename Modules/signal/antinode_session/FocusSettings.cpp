#include "FocusSettings.h"

#include <antinode_focus/TargetField.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace antinode
{
namespace
{
constexpr double thousandth = 1e-3;

/** Hosts keep parameters as shares of their range: what comes back may differ in the last digits of a float. */
bool isSame (float one, float other)
{
    return std::abs (one - other) <= 2e-6F * std::max (1.0F, std::abs (other));
}

double percentBetween (double value, double minimum, double maximum)
{
    return maximum > minimum ? 100 * (value - minimum) / (maximum - minimum) : 50.0;
}

double fromPercent (double percent, double minimum, double maximum)
{
    return minimum + (maximum - minimum) * std::clamp (percent, 0.0, 100.0) / 100;
}

/** A place that the focus gives stays as it is where the parameters say the same. */
std::pair<double, double> placeOr (std::pair<double, double> given, const Surface& surface, float xPercent,
                                   float yPercent)
{
    const auto [x, y] = percentFromPlace (surface, given.first, given.second);
    const auto wanted = placeFromPercent (surface, xPercent, yPercent);
    const std::pair place { isSame (xPercent, static_cast<float> (x)) ? given.first : wanted.first,
                            isSame (yPercent, static_cast<float> (y)) ? given.second : wanted.second };
    return ! surface.boundary || liesOn (surface, place.first, place.second) ? place : wanted;
}

void applyTarget (FocusDescription& focus, const PlaySettings& settings, const PlaySettings& loaded,
                  const Surface& surface)
{
    auto& first = focus.targets.front();
    const auto before = first;
    std::tie (first.x, first.y) = placeOr ({ first.x, first.y }, surface, settings.xPercent, settings.yPercent);
    first.shape = settings.shape;

    if (! isSame (settings.widthMillimetres, loaded.widthMillimetres))
        first.width = static_cast<double> (settings.widthMillimetres) * thousandth;

    if (! isSame (settings.peakVelocityMillimetresPerSecond, loaded.peakVelocityMillimetresPerSecond))
    {
        first.peakVelocity = static_cast<double> (settings.peakVelocityMillimetresPerSecond) * thousandth;
        first.level.reset();
    }

    for (std::size_t i = 1; i < focus.targets.size(); ++i)
    {
        focus.targets[i].x += first.x - before.x;
        focus.targets[i].y += first.y - before.y;
        focus.targets[i].peakVelocity *= first.peakVelocity / before.peakVelocity;
    }
}
/** A train keeps its rhythm. */
void moveInTime (FocusDescription& focus, double focusTime)
{
    for (auto& target : focus.targets)
        if (target.time)
            *target.time = std::max (*target.time + focusTime - focus.focusTime, thousandth);

    focus.focusTime = focusTime;
}
} // namespace

std::pair<double, double> placeFromPercent (const Surface& surface, double xPercent, double yPercent)
{
    const auto x = fromPercent (xPercent, surface.xMinimum, surface.xMaximum);
    const auto y = fromPercent (yPercent, surface.yMinimum, surface.yMaximum);

    if (! surface.boundary)
        return { x, y };

    const auto place = nearestOn (surface, x, y);
    return { place.x(), place.y() };
}

std::pair<double, double> percentFromPlace (const Surface& surface, double x, double y)
{
    return { percentBetween (x, surface.xMinimum, surface.xMaximum),
             percentBetween (y, surface.yMinimum, surface.yMaximum) };
}

PlaySettings settingsFromFocus (const FocusDescription& focus, const Surface& surface, const PlaySettings& present)
{
    auto settings = present;
    const auto& target = focus.targets.front();
    const auto [x, y] = percentFromPlace (surface, target.x, target.y);
    settings.xPercent = static_cast<float> (x);
    settings.yPercent = static_cast<float> (y);
    settings.widthMillimetres = static_cast<float> (target.width / thousandth);
    settings.shape = target.shape;
    settings.peakVelocityMillimetresPerSecond = static_cast<float> (target.peakVelocity / thousandth);
    settings.focusTimeMilliseconds = static_cast<float> (focus.focusTime / thousandth);
    settings.growth = -1;
    settings.brake = 0;
    settings.retired = focus.allocation.retired;
    settings.method = settings.retired != nullptr ? settings.retired->method : focus.allocation.method;
    settings.voltageLimitVolts = 0;
    settings.modeCount = 0;

    if (! focus.probes.empty())
    {
        const auto probe = percentFromPlace (surface, focus.probes.front().first, focus.probes.front().second);
        settings.probeXPercent = static_cast<float> (probe.first);
        settings.probeYPercent = static_cast<float> (probe.second);
    }

    return settings;
}

FocusDescription withMethod (FocusDescription focus, AllocationMethod method, const RetiredMethod* retired)
{
    auto& choice = focus.allocation;

    if (choice.retired == retired && (retired != nullptr || choice.method == method))
        return focus;

    choice.retired = nullptr;
    choice.method = method;
    choice.timesBound.reset();

    if (retired != nullptr)
        choice = withRetired (choice, *retired);

    // Robust designs were never asked for by the methods that are no longer offered.
    if (retired != nullptr || method == AllocationMethod::paper)
        choice.robust.reset();

    if (! choice.isUpToLimits())
        focus.felt.reset();

    choice.isUndisplaced = choice.isUndisplaced && choice.method == AllocationMethod::exact;
    return focus;
}

FocusDescription withSettings (const FocusDescription& document, const PlaySettings& settings, const Surface& surface)
{
    auto focus = document;
    const auto loaded = settingsFromFocus (document, surface, settings);
    applyTarget (focus, settings, loaded, surface);
    focus = withMethod (std::move (focus), settings.method, settings.retired);

    if (! isSame (settings.focusTimeMilliseconds, loaded.focusTimeMilliseconds))
        moveInTime (focus, static_cast<double> (settings.focusTimeMilliseconds) * thousandth);

    if (settings.growth >= 0)
        focus.transients.growth = { static_cast<double> (settings.growth) };

    if (settings.brake > 1)
        focus.transients.brake = static_cast<double> (settings.brake);

    // It only lowers: what the focus allows holds too.
    if (const auto limit = static_cast<double> (settings.voltageLimitVolts); limit > 0)
        focus.allocation.voltageLimit = std::min (limit, focus.allocation.voltageLimit.value_or (limit));

    if (settings.modeCount > 0)
        focus.modes = { settings.modeCount, focus.modes.order, {}, {}, {} };

    // Lists of one value per mode fit only the modes that they were written for.
    if (settings.modeCount > 0 && focus.transients.growth.size() > 1)
        focus.transients.growth.clear();

    if (settings.modeCount > 0 && focus.transients.cycles.size() > 1)
        focus.transients.cycles.clear();

    return focus;
}

std::int64_t estimateLatency (const FocusDescription& document, const PlaySettings& settings, double sampleRate)
{
    // Times do not depend on the surface.
    return settings.focusOnNote
               ? std::llround (earliestFocusTime (withSettings (document, settings, Surface {})) * sampleRate)
               : 0;
}

double estimateEnd (const FocusDescription& document, const PlaySettings& settings)
{
    const auto focus = withSettings (document, settings, Surface {});
    return latestFocusTime (focus) + focus.transients.brakeDuration.value_or (0);
}

std::vector<std::pair<double, double>> probePlaces (const FocusDescription& document, const PlaySettings& settings,
                                                    const Surface& surface)
{
    const auto& target = document.targets.front();
    const auto first = document.probes.empty() ? std::pair (target.x, target.y) : document.probes.front();
    const auto focus = withSettings (document, settings, surface).targets.front();
    const auto second = document.probes.size() > 1 ? document.probes[1] : std::pair (focus.x, focus.y);
    return { placeOr (first, surface, settings.probeXPercent, settings.probeYPercent), second };
}
} // namespace antinode
