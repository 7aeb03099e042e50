#include "Support/ErrorText.h"

#include <antinode_documents/HapticContent.h>
#include <antinode_documents/Inputs.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>

using namespace antinode;
using Json = nlohmann::json;

namespace
{
/** Patterns by Apple's grammar: any entries, missing keys, values out of range, keys that nobody knows. */
class PatternMaker
{
public:
    explicit PatternMaker (std::uint64_t seed) : random (seed) {}

    Json document()
    {
        Json entries = Json::array ({ { { "Event", { { "EventType", "HapticTransient" }, { "Time", 0.1 } } } } });

        for (auto i = below (20); i > 0; --i)
            entries.push_back (chance (0.6) ? event() : chance (0.5) ? parameter() : curve());

        Json whole { { "Pattern", entries } };

        if (chance (0.7))
            whole["Version"] = 1.0;

        if (chance (0.3))
            whole["Metadata"] = { { "Project", "any" } };

        return whole;
    }

    /** The same as text with one fault. */
    std::string broken()
    {
        auto text = document().dump();
        const auto place = below (static_cast<int> (text.size()));

        switch (below (5))
        {
            case 0:
                text.resize (static_cast<std::size_t> (place)); // cut
                break;
            case 1:
                text[static_cast<std::size_t> (place)] = static_cast<char> (below (256));
                break;
            case 2:
                text.erase (static_cast<std::size_t> (place), 1 + static_cast<std::size_t> (below (8)));
                break;
            case 3:
                text.insert (static_cast<std::size_t> (place), "[[[[");
                break;
            default:
                replaceNumber (text);
        }

        return text;
    }

    int below (int count) { return static_cast<int> (random.uniform() * count); }
    bool chance (double share) { return random.uniform() < share; }

private:
    /** A number becomes one that is none, or is far too large. */
    void replaceNumber (std::string& text)
    {
        if (const auto at = text.find ("\"Time\":"); at != std::string::npos)
            text.insert (at + 7, chance (0.5) ? "-" : "1e3000");
    }

    double value() { return chance (0.2) ? 20 * random.uniform() - 10 : random.uniform(); }
    double time() { return 3 * random.uniform(); }

    Json event()
    {
        static const std::vector<std::string> kinds { "HapticTransient", "HapticContinuous", "HapticContinuous",
                                                      "AudioContinuous", "AudioCustom" };
        static const std::vector<std::string> ids { "HapticIntensity", "HapticSharpness", "AttackTime",  "DecayTime",
                                                    "ReleaseTime",     "Sustained",       "AudioVolume", "Nobody" };
        Json body { { "EventType", kinds[static_cast<std::size_t> (below (5))] } };

        if (chance (0.9))
            body["Time"] = time();

        if (chance (0.8))
            body["EventDuration"] = random.uniform();

        if (chance (0.9))
            for (auto i = below (6); i >= 0; --i)
                body["EventParameters"].push_back (
                    { { "ParameterID", ids[static_cast<std::size_t> (below (8))] }, { "ParameterValue", value() } });

        return { { "Event", body } };
    }

    std::string control()
    {
        static const std::vector<std::string> ids { "HapticIntensityControl", "HapticSharpnessControl",
                                                    "HapticAttackTimeControl", "HapticReleaseTimeControl",
                                                    "AudioVolumeControl" };
        return ids[static_cast<std::size_t> (below (5))];
    }

    Json parameter()
    {
        return { { "Parameter", { { "ParameterID", control() }, { "ParameterValue", value() }, { "Time", time() } } } };
    }

    Json curve()
    {
        Json points = Json::array();

        for (auto i = below (16); i > 0; --i)
            points.push_back ({ { "Time", random.uniform() }, { "ParameterValue", value() } });

        return { { "ParameterCurve",
                   { { "ParameterID", control() }, { "Time", time() }, { "ParameterCurveControlPoints", points } } } };
    }

    RandomNumbers random;
};

void read (const std::string& text)
{
    const auto waveforms = waveformsFromDocument (waveformsDocument (text, "my.ahap"), "my.ahap", "my.ahap");

    for (const auto& event : waveforms.tracks.at (0).events)
    {
        const auto& points = std::get<VibrationSignal> (event.signal).points;
        REQUIRE (event.amplitude > 0);
        REQUIRE (event.amplitude <= 1);
        REQUIRE (points.back().amplitude == Approx (0).margin (1e-6));

        for (const auto& point : points)
            REQUIRE (
                (point.frequency >= 65 && point.frequency <= 300 && std::abs (point.amplitude) <= event.amplitude));
    }
}
} // namespace

TEST_CASE ("100 patterns by the grammar are read", "[documents][haptics]")
{
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
    {
        CAPTURE (seed);
        CHECK_NOTHROW (read (PatternMaker (seed).document().dump()));
    }
}

TEST_CASE ("100 patterns with a fault are read or refused in one sentence that names the file", "[documents][haptics]")
{
    int refused = 0;

    for (std::uint64_t seed = 1; seed <= 100; ++seed)
    {
        const auto text = PatternMaker (seed).broken();
        const auto message = errorText ([&] { read (text); });
        CAPTURE (seed, message, text);
        CHECK ((message.empty() || message.starts_with ("my.ahap")));
        CHECK (std::none_of (message.begin(), message.end(),
                             [] (char c) { return static_cast<unsigned char> (c) < 0x20; }));
        refused += message.empty() ? 0 : 1;
    }

    CHECK (refused > 50);
}
