#include "Support/ErrorText.h"
#include "Support/TemporaryFolder.h"

#include <antinode_base/System.h>
#include <antinode_sweep/CaseEvaluator.h>
#include <antinode_sweep/PartFolder.h>
#include <antinode_sweep/SweepTable.h>
#include <antinode_text/OutputFolder.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>

using namespace antinode;

namespace
{
SweepInputs inputsOfFolder (const TemporaryFolder& folder, int cases)
{
    const auto file = folder.path() / "given.json";
    writeWholeFile (
        file,
        R"({"schema": "antinode.sweep/1", "focus": "demonstrator", "device": "beam", "scheme": "random", "cases": )"
            + std::to_string (cases)
            + R"(, "evaluate": "closed_form", "record": ["field_error_truncated", "peak_ratio"],
        "vary": [{"key": "deviation.damping_percent", "uniform": {"minimum": -10, "maximum": 10}}]})");
    return loadSweep (file);
}

std::string csvOf (const PartFolder& folder, const SweepInputs& inputs)
{
    return sweepToCsv (mergeParts (folder, inputs), [] (std::string text) { return text; });
}

void compute (const SweepInputs& inputs, const PartFolder& folder, SweepShard shard, std::size_t threads)
{
    const CaseEvaluator evaluator (inputs, false);
    computeParts ([&] (std::uint64_t number) { return evaluator.evaluate (number); }, folder, folder.missing (shard),
                  threads, {});
}
} // namespace

TEST_CASE ("Parts cover all cases once, some 500 of them", "[sweep]")
{
    for (const std::uint64_t cases : { 1, 2, 499, 500, 10'000, 12'345, 10'000'000 })
    {
        const auto parts = sweepParts (cases);
        std::uint64_t next = 0;

        for (const auto& part : parts)
        {
            CHECK (part.first == next);
            next += part.count;
        }

        CHECK (next == cases);
        CHECK (parts.size() <= 1001);
    }
}

TEST_CASE ("Shards of any number merge to the bytes of a single run", "[sweep]")
{
    const TemporaryFolder folder;
    const auto inputs = inputsOfFolder (folder, 40);
    const auto single = sweepFolder (folder.path() / "single", inputs),
               seven = sweepFolder (folder.path() / "seven", inputs);
    compute (inputs, single, {}, 1);

    for (const std::uint64_t i : { 3, 1, 7, 2, 6, 5 })
        compute (inputs, seven, { i, 7 }, 2);

    CHECK_THAT (errorText ([&] { mergeParts (seven, inputs); }), Catch::Contains ("6 of 40 parts are missing"));
    compute (inputs, seven, { 4, 7 }, 2);
    CHECK (csvOf (single, inputs) == csvOf (seven, inputs));
    CHECK (sweepToMatlab (mergeParts (single, inputs)) == sweepToMatlab (mergeParts (seven, inputs)));
}

TEST_CASE ("Damaged parts are computed again, parts of other plans are refused", "[sweep]")
{
    const TemporaryFolder folder;
    const auto inputs = inputsOfFolder (folder, 5), others = inputsOfFolder (folder, 6);
    const auto path = folder.path() / "out";
    const auto parts = sweepFolder (path, inputs);
    compute (inputs, parts, {}, 1);
    const auto whole = csvOf (parts, inputs);

    std::filesystem::resize_file (path / "parts" / "00000002.part", 40);
    std::ofstream (path / "parts" / "00000003.part") << "no part";
    CHECK (parts.missing ({}) == std::vector<std::size_t> { 2, 3 });
    CHECK_THAT (errorText ([&] { parts.read (2); }), Catch::Contains ("missing or damaged"));
    compute (inputs, parts, {}, 1);
    CHECK (csvOf (parts, inputs) == whole);

    CHECK_THAT (errorText ([&] { sweepFolder (path, others); }), Catch::Contains ("another plan"));
    const auto second = sweepFolder (folder.path() / "second", others);
    compute (others, second, {}, 1);
    std::filesystem::copy_file (folder.path() / "second" / "parts" / "00000001.part", path / "parts" / "00000001.part",
                                std::filesystem::copy_options::overwrite_existing);
    CHECK_THAT (errorText ([&] { (void) parts.missing ({}); }), Catch::Contains ("belongs to another plan"));
}

TEST_CASE ("Tables have all cases, also those that failed", "[sweep]")
{
    const TemporaryFolder folder;
    writeWholeFile (folder.path() / "given.json",
                    R"({"schema": "antinode.sweep/1", "focus": "demonstrator", "device": "beam",
        "evaluate": "closed_form", "record": ["v_score"],
        "vary": [{"key": "focus.targets.0.x_mm", "values": [24, 900, 30]}]})");
    const auto inputs = loadSweep (folder.path() / "given.json");
    const auto parts = sweepFolder (folder.path() / "out", inputs);
    compute (inputs, parts, {}, 1);
    const auto table = mergeParts (parts, inputs);
    REQUIRE (table.failed() == 1);
    CHECK (std::isnan (table.values (1, 0)));

    // The cases' numbers, the key and the result: three doubles each, NaN where there is none.
    const auto bytes = sweepToMatlab (table);
    const auto holds = [&] (double a, double b, double c)
    {
        const std::array numbers { a, b, c };
        return bytes.find (std::string (reinterpret_cast<const char*> (numbers.data()), sizeof (numbers)))
               != std::string::npos;
    };
    CHECK (holds (0, 1, 2));
    CHECK (holds (24, 900, 30));
    CHECK (holds (table.values (0, 0), table.values (1, 0), table.values (2, 0)));
    CHECK_THAT (csvOf (parts, inputs), Catch::Contains ("\n1,900,,") && Catch::Contains ("outside the surface"));
}

TEST_CASE ("Parts that others have encoded make the same folder, and those of other plans are refused", "[sweep]")
{
    const TemporaryFolder folder;
    const auto inputs = inputsOfFolder (folder, 5), others = inputsOfFolder (folder, 6);
    const auto single = sweepFolder (folder.path() / "single", inputs),
               kept = sweepFolder (folder.path() / "kept", inputs);
    compute (inputs, single, {}, 1);

    // As a worker has it: the plan with its documents, which names no file.
    const auto received = sweepInputs (nlohmann::json::parse (inputs.document.dump()), "plan");
    REQUIRE (received.hash == inputs.hash);
    const CaseEvaluator evaluator (received, false);
    int cases = 0;

    for (std::size_t i = 0; i < kept.parts().size(); ++i)
    {
        CHECK (kept.written() == i);
        const auto part = kept.parts()[i];
        const auto results =
            computePart ([&] (std::uint64_t number) { return evaluator.evaluate (number); }, part, [&] { ++cases; });
        kept.keep (i, encodePart (received.hash, part.first, results));
    }

    CHECK (cases == 5);
    CHECK (kept.written() == kept.parts().size());
    CHECK (csvOf (kept, inputs) == csvOf (single, inputs));

    const auto part = encodePart (inputs.hash, 0, single.read (0));
    CHECK_THAT (errorText ([&] { kept.keep (0, encodePart (others.hash, 0, single.read (0))); }),
                Catch::Contains ("part 0: is of another plan"));
    CHECK_THAT (errorText ([&] { kept.keep (1, part); }), Catch::Contains ("part 1: is of another plan"));
    CHECK_FALSE (errorText ([&] { kept.keep (0, part.substr (0, part.size() - 1)); }).empty());
    CHECK (csvOf (kept, inputs) == csvOf (single, inputs));
}

TEST_CASE ("A part's bytes are read as they were written, and no others", "[sweep]")
{
    const std::vector<CaseResult> results { { { 1, -2.5 }, {} },
                                            { { std::nan (""), std::nan ("") }, "failed, \"so\"" } };
    const auto bytes = encodePart ("hash", 17, results);
    const auto part = decodePart (bytes);
    CHECK (part.hash == "hash");
    CHECK (part.first == 17);
    CHECK (part.results[0].values == results[0].values);
    CHECK (part.results[1].error == results[1].error);

    for (std::size_t length = 0; length < bytes.size(); ++length)
        CHECK_FALSE (errorText ([&] { decodePart (std::string_view (bytes).substr (0, length)); }).empty());
}

TEST_CASE ("A shard is one of its number", "[sweep]")
{
    CHECK (readShard ("7/7").index == 7);

    for (const auto* text :
         { "8/7", "0/7", "1/0", "1", "/7", "1/", "1/2/3", "-1/7", "1/99999999999999999999", "a/b", "" })
        CHECK_THAT (errorText ([&] { readShard (text); }), Catch::Contains ("allowed: I/N"));
}

TEST_CASE ("The next start removes what a dead process of this computer left, and no other's", "[sweep]")
{
    const TemporaryFolder scratch;
    const auto name = [] (const std::string& computer, int process)
    { return ".part-" + computer + "-" + std::to_string (process) + "-1"; };
    constexpr auto dead = 4194304; // above what Linux gives
    const auto parts = scratch.path() / "parts";
    std::filesystem::create_directories (parts);
    const auto left = parts / name (computerName(), dead), running = parts / name (computerName(), ownProcess()),
               elsewhere = parts / name (computerName() + "x", dead);

    for (const auto& file : { left, running, elsewhere })
        std::ofstream (file) << "x";

    const PartFolder folder (scratch.path(), "hash", 10);
    CHECK_FALSE (std::filesystem::exists (left));
    CHECK (std::filesystem::exists (running));
    CHECK (std::filesystem::exists (elsewhere));
}
