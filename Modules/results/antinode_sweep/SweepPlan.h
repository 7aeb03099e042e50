#pragma once

#include "Distribution.h"

#include <antinode_text/JsonReader.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** How the cases of a plan are spread over what varies. */
enum class SweepScheme
{
    grid,  ///< All combinations of listed values, the first keys varying slowest.
    random ///< Each case for itself.
};

/** What a case is judged by. */
enum class SweepEvaluation
{
    render,    ///< What summary.json of a render says, or of a performance of waveforms.
    closedForm ///< The field at the first focus, by formula; a subset of the keys, some hundred times as fast.
};

/** Keys that move together: one dimension of a plan. */
struct SweptKeys
{
    std::vector<std::string> keys;                 ///< "focus.targets.0.x_mm", one or more.
    std::vector<std::vector<nlohmann::json>> rows; ///< Listed values, one per key; empty where they are drawn.
    std::optional<Distribution> drawn;
    std::vector<double> times, plus; ///< Of drawn ones, one per key: value = plus + times * what is drawn.
};

/** What is computed for many cases. Docs/FileFormats.md, antinode.sweep/1. */
struct SweepPlan
{
    std::string name;
    nlohmann::json focus, waveforms; ///< A name or a file's name, or the document itself: one of them; the other null.
    nlohmann::json device;           ///< The same; null: the one that focus or waveforms name.
    nlohmann::json
        devices; ///< Where "device" varies: documents by what it is given; null: they are read by these names.
    SweepScheme scheme = SweepScheme::grid;
    std::uint64_t seed = 1;
    std::uint64_t cases = 1;                                 ///< All of them.
    std::vector<std::pair<std::string, nlohmann::json>> set; ///< Keys that are the same in all cases.
    std::vector<SweptKeys> vary;
    SweepEvaluation evaluation = SweepEvaluation::render;
    std::vector<std::string> record;               ///< Keys of summary.json, with points between their parts.
    std::vector<std::pair<double, double>> points; ///< x, y, m: where the field at the first focus is recorded.
    double sampleRate = 192000;                    ///< Hz; of waveforms 48000 where none is given.
    double latency = 0;                            ///< s: of live waveforms.

    bool isOfWaveforms() const { return ! waveforms.is_null(); }

    /** What "device" is given where it varies: names or files; else nothing. [any] */
    std::vector<std::string> variedDevices() const;
};

/** How many cases a plan may have, and how many values of one case may be recorded. */
inline constexpr std::uint64_t maximumSweepCases = 10'000'000;
inline constexpr std::size_t maximumSweepColumns = 1000;

/** A plan from its document.
    @param source  how errors name it
    @throws InputError  source, JSON pointer, what is wrong, what is allowed
    [worker] */
SweepPlan readSweepPlan (const nlohmann::json&, const std::string& source);

/** A key as --set has it, one of a deviation, or "device". @param value  whose place errors name
    @throws InputError  when it is neither [worker] */
std::string readSweptKey (const JsonValue& value, const std::string& key);

/** A value of a key: no list and no object, which would change the document's shape.
    @throws InputError  when it is one [worker] */
const nlohmann::json& readScalar (const JsonValue&, const nlohmann::json& json);

/** An entry of "vary". @param json  the same value @throws InputError  as readSweepPlan [worker] */
SweptKeys readSweptKeys (const JsonValue&, const nlohmann::json& json);
} // namespace antinode
