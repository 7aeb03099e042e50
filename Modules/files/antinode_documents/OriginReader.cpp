#include "OriginReader.h"

namespace antinode
{
namespace
{
constexpr WordList<ModeSource, 4> sourceWords { { { "given", ModeSource::given },
                                                  { "drawn", ModeSource::drawn },
                                                  { "retuned", ModeSource::retuned },
                                                  { "measured", ModeSource::measured } } };
constexpr WordList<bool, 2> scaleWords { { { "known", true }, { "convention", false } } };
constexpr int mostPoints = 1000000;
constexpr double percent = 100;
} // namespace

ModeOrigin readOrigin (const JsonValue& value)
{
    const auto object = value.object ({ "modes", "points", "unexplained_percent", "scale" });
    ModeOrigin origin { object.required ("modes").choice (sourceWords) };

    if (const auto points = object.optional ("points"))
        origin.points = points->integer (0, mostPoints);

    if (const auto unexplained = object.optional ("unexplained_percent"))
        origin.unexplained = unexplained->number ({ 0, percent }) / percent;

    if (const auto scale = object.optional ("scale"))
        origin.scaleIsKnown = scale->choice (scaleWords);

    return origin;
}

nlohmann::ordered_json originToJson (const ModeOrigin& origin)
{
    nlohmann::ordered_json json { { "modes", wordFor (sourceWords, origin.source) } };

    if (origin.points > 0)
    {
        json["points"] = origin.points;
        json["unexplained_percent"] = percent * origin.unexplained;
    }

    if (! origin.scaleIsKnown)
        json["scale"] = wordFor (scaleWords, false);

    return json;
}
} // namespace antinode
