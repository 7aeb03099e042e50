#include "Support/ErrorText.h"
#include "Support/TemporaryFolder.h"

#include <antinode_documents/Inputs.h>
#include <antinode_focus/Tolerance.h>
#include <antinode_sweep/CaseEvaluator.h>
#include <antinode_sweep/PartFolder.h>
#include <antinode_sweep/SweepCases.h>
#include <antinode_text/OutputFolder.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

namespace
{
SweepInputs inputsOf (const TemporaryFolder& folder, const std::string& more, const std::string& name = "plan.json")
{
    const auto file = folder.path() / name;
    const std::string device = more.find ("\"device\"") == std::string::npos ? R"("device": "beam", )" : "";
    writeWholeFile (file, R"({"schema": "antinode.sweep/1", "focus": "demonstrator", )" + device + more + "}");
    return loadSweep (file);
}
} // namespace

TEST_CASE ("The closed form gives what a render measures", "[sweep]")
{
    const TemporaryFolder folder;
    const std::string keys = R"("record": ["v_score", "field_error", "v_score_truncated", "peak_ratio", "captured",
        "spill_over.share"], "points_mm": [[24, 0]],
        "set": {"deviation.frequency_percent": 0.2, "deviation.damping_percent": -5, "deviation.voltage_percent": 3,
                "deviation.frequency_spread_percent": 0.1})";
    const auto formula = CaseEvaluator (inputsOf (folder, keys + R"(, "evaluate": "closed_form")"), false).evaluate (0);
    const auto played = CaseEvaluator (inputsOf (folder, keys + R"(, "evaluate": "render")"), false).evaluate (0);
    REQUIRE (formula.error.empty());
    REQUIRE (played.error.empty());

    // The design meets its rows to the release at the focus, which the samples' interpolation rounds off: 5e-5 of the
    // field on the nominal device, 2e-4 on these.
    for (std::size_t i = 0; i < formula.values.size(); ++i)
        CHECK (formula.values[i] == Approx (played.values[i]).epsilon (3e-4).margin (2e-5));
}

TEST_CASE ("Deviations that all modes share are those of the device's own file", "[sweep]")
{
    const TemporaryFolder folder;
    const std::string record = R"("evaluate": "closed_form", "record": ["field_error"], )";
    const auto errorAt = [&] (const std::string& set)
    { return CaseEvaluator (inputsOf (folder, record + R"("set": {)" + set + "}"), false).evaluate (0).values.at (0); };
    const auto none = errorAt ("");
    // A wrong gain of g adds its own error at right angles or along the field: nothing at 0.
    CHECK (errorAt (R"("deviation.voltage_percent": 0)") == none);
    CHECK (errorAt (R"("deviation.voltage_percent": 10)") != none);
    // Voltages and participations are only known as products.
    CHECK (errorAt (R"("deviation.voltage_percent": 10)")
           == Approx (errorAt (R"("deviation.participation_percent": 10)")).epsilon (1e-12));
}

TEST_CASE ("Drawn devices have the percentiles of --tolerance", "[sweep]")
{
    const TemporaryFolder folder;
    const auto inputs = inputsOf (folder, R"("scheme": "random", "cases": 400, "evaluate": "closed_form",
        "record": ["field_error_truncated"], "set": {"deviation.frequency_spread_percent": 0.1,
        "deviation.damping_spread_percent": 10, "deviation.participation_spread_percent": 5})");
    const CaseEvaluator evaluator (inputs, false);
    std::vector<double> errors;

    for (std::uint64_t i = 0; i < inputs.plan.cases; ++i)
        errors.push_back (evaluator.evaluate (i).values.front());

    const auto model = solveDevice (loadDevice ("beam", {}), {}, false);
    const auto design = designFocus (model, loadFocus ("demonstrator", {}), { Reconstruction::bandLimited, 192000 },
                                     DesignExtent::compared);
    ToleranceOptions options;
    options.draws = 400;
    const auto tolerance = evaluateTolerance (model, design, options, [] (double) {});
    const auto here = computePercentiles (errors);

    // Medians of 400 draws each: their standard error is about 6 % of the spread, which is half of the median here.
    CHECK (here[2] == Approx (tolerance.fieldError[2]).epsilon (0.15));
    CHECK (here[4] == Approx (tolerance.fieldError[4]).epsilon (0.25));
}

TEST_CASE ("A case has the same bits whatever was computed before it", "[sweep]")
{
    const TemporaryFolder folder;
    const auto inputs = inputsOf (folder, R"("scheme": "random", "cases": 24, "evaluate": "closed_form",
        "record": ["v_score", "field_error", "peak_voltage_V"], "vary": [
            {"key": "focus.targets.0.x_mm", "uniform": {"minimum": 0, "maximum": 60}},
            {"key": "deviation.damping_percent", "normal": {"mean": 0, "standard_deviation": 10}}])");
    const CaseEvaluator forwards (inputs, false), backwards (inputs, false);
    std::vector<CaseResult> first (24), second (24);

    for (std::uint64_t i = 0; i < 24; ++i)
        first[i] = forwards.evaluate (i);

    for (std::uint64_t i = 24; i-- > 0;)
        second[i] = backwards.evaluate (i);

    CHECK (encodePart ("a", 0, first) == encodePart ("a", 0, second));
    CHECK (first[3].values != first[4].values);
}

TEST_CASE ("A case that cannot be done says why and stops no other", "[sweep]")
{
    const TemporaryFolder folder;
    const CaseEvaluator evaluator (inputsOf (folder, R"("evaluate": "closed_form", "record": ["v_score"],
        "vary": [{"key": "focus.targets.0.x_mm", "values": [24, 900]}])"),
                                   false);
    evaluator.check();
    CHECK (evaluator.evaluate (0).error.empty());
    const auto failed = evaluator.evaluate (1);
    CHECK_THAT (failed.error, Catch::Contains ("outside the surface"));
    CHECK (std::isnan (failed.values.front()));
}

TEST_CASE ("Keys that documents do not know, and results that no case has, are refused before anything is computed",
           "[sweep]")
{
    const TemporaryFolder folder;
    const auto refusal = [&] (const std::string& more)
    { return errorText ([&] { CaseEvaluator (inputsOf (folder, more), false).check(); }); };
    CHECK_THAT (refusal (R"("record": ["v_score"], "vary": [{"key": "focus.colour", "values": [1]}])"),
                Catch::Contains ("colour"));
    CHECK_THAT (refusal (R"("evaluate": "closed_form", "record": ["w_score"])"),
                Catch::Contains ("'w_score' is not the number of a case; allowed: 'modes_controlled'"));
    CHECK_THAT (refusal (R"("evaluate": "closed_form", "record": ["v_score"], "set": {"focus.targets.0.x_mm": 900})"),
                Catch::Contains ("none of 16 cases"));
}

TEST_CASE ("A plan's hash changes with the documents that it names", "[sweep]")
{
    const TemporaryFolder folder;
    const auto plain = inputsOf (folder, R"("record": ["v_score"])");
    CHECK (plain.hash.size() == 32);
    CHECK (inputsOf (folder, R"("record": ["v_score"])").hash == plain.hash);
    CHECK (inputsOf (folder, R"("record": ["field_error"])").hash != plain.hash);
    CHECK (inputsOf (folder, R"("record": ["v_score"], "device": "staple")").hash != plain.hash);

    // What a folder keeps needs no other file and is the same plan.
    writeWholeFile (folder.path() / "kept.json", plain.document.dump());
    CHECK (loadSweep (folder.path() / "kept.json").hash == plain.hash);
}
