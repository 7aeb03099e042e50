#include "Render.h"

#include <antinode_base/Prefixes.h>
#include <antinode_documents/SkinThresholds.h>

namespace antinode
{
std::vector<Field> fields (RenderRequest& request)
{
    constexpr double milliseconds = 1000;
    auto all = fields (request.design);
    all.front().value = FocusOrDesign { &request.design.focus, &request.made };
    append (all, { Field ("--probe",
                          NumberRows { "X or X,Y in mm, for example 24 or 24,10", 1, 2, true,
                                       [&request] (const auto& place) {
                                           request.probes.emplace_back (place[0] / milli,
                                                                        place.size() > 1 ? place[1] / milli : 0);
                                       } },
                          "Position of a velocity probe, mm (repeatable)")
                       .as ("probes_mm")
                       .written ("X,Y", ','),
                   Field ("--duration-ms", &request.duration, "Rendered duration from the trigger, ms")
                       .in (milliseconds)
                       .by ("until the surface has calmed down"),
                   Field ("--block-size", &request.blockSize, "Samples per block; does not affect the result")
                       .within (1, 8193) });
    return all;
}

RenderOptions renderOptions (const RenderRequest& request, const DesignedFocus& designed)
{
    RenderOptions options;
    options.playback = designed.playback;
    options.blockSize = request.blockSize;
    options.repetitions = designed.repetitions;
    options.threshold = findSkinThreshold (designed.thresholdFile.string());
    options.duration = request.duration;
    options.probes = request.probes;
    return options;
}

RenderedDesign render (const RenderRequest& request, const ShowProgress& show)
{
    const auto designed =
        request.made ? request.made : std::make_shared<const DesignedFocus> (design (request.design, show));
    auto focus = renderFocus (designed->made.wide, designed->made.design, renderOptions (request, *designed),
                              [&] (double share)
                              {
                                  if (show)
                                      show ("Rendering", share);
                              });
    auto outcome = evaluateOutcome (focus);
    return { designed, std::move (focus), std::move (outcome) };
}
} // namespace antinode
