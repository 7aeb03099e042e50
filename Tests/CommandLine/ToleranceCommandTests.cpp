#include "Support/RunProgram.h"

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <filesystem>

using namespace antinode;
using test::readContent;
using test::runProgram;

TEST_CASE ("design --tolerance writes a table, a page and numbers, the same on every run", "[command line]")
{
    const TemporaryFolder folder;
    const auto path = folder.path().string();
    const auto run = runProgram ({ "design", "--tolerance", "--draws", "40", "--seed", "3", "--out", path });
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    CHECK (run.output.find ("field error (%)") != std::string::npos);
    CHECK (run.output.find ("alone change") != std::string::npos);
    const auto text = readContent (folder.path() / "tolerance.json");
    const auto page = readContent (folder.path() / "tolerance.html");
    CHECK (page.find ("Largest causes of error") != std::string::npos);
    const auto json = nlohmann::json::parse (text);
    CHECK (json["schema"] == "antinode.tolerance/1");
    CHECK (json["spread"]["frequency_percent"] == 0.15);
    CHECK (json["designs"].size() == 1);
    CHECK (json["designs"][0]["draws"].size() == 40);
    CHECK (json["designs"][0]["v_score"].size() == json["percentiles"].size());

    // On a device of this kind, 30 draws of 0.1 %, 10 % and 5 %: median of the v-score .997 to .9998.
    CHECK (json["designs"][0]["v_score"][2] > 0.997);
    CHECK (json["designs"][0]["v_score"][2] < 0.9998);

    REQUIRE (runProgram ({ "design", "--tolerance", "--draws", "40", "--seed", "3", "--quiet", "--out", path }).exitCode
             == 0);
    CHECK (readContent (folder.path() / "tolerance.json") == text);
    CHECK (readContent (folder.path() / "tolerance.html") == page);
}

TEST_CASE ("Many draws are those of few and more, kept in parts until they are done", "[command line]")
{
    const TemporaryFolder folder;
    const auto drawn = [&] (const std::string& count, const std::string& name)
    {
        const auto path = folder.path() / name;
        REQUIRE (runProgram ({ "design", "--tolerance", "--draws", count, "--quiet", "--out", path.string() }).exitCode
                 == 0);
        CHECK_FALSE (std::filesystem::exists (path / "tolerance-draws"));
        return nlohmann::json::parse (readContent (path / "tolerance.json"))["designs"][0]["draws"];
    };
    const auto few = drawn ("20", "few"), many = drawn ("1001", "many");
    REQUIRE (many.size() == 1001);

    for (std::size_t i = 0; i < few.size(); ++i)
        CHECK (many[i] == few[i]);
}

TEST_CASE ("A robust focus is compared with what it would be without, at the spreads that it names", "[command line]")
{
    const TemporaryFolder folder;
    const auto run = runProgram ({ "design", "--tolerance", "--draws", "60", "--damping-percent", "12", "--out",
                                   folder.path().string(), "--set", "focus.allocation.robust.frequency_percent=0.3" });
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    const auto json = nlohmann::json::parse (readContent (folder.path() / "tolerance.json"));
    CHECK (json["spread"]["frequency_percent"] == 0.3);
    CHECK (json["spread"]["damping_percent"] == 12);
    REQUIRE (json["designs"].size() == 2);
    const auto& nominal = json["designs"][0];
    const auto& robust = json["designs"][1];
    CHECK (nominal["design"] == "nominal");
    CHECK (robust["design"] == "robust");

    // Measured with 200 devices: median 0.42 and 95 % 0.36 times that of the nominal design.
    CHECK (robust["field_error"][2].get<double>() < 0.55 * nominal["field_error"][2].get<double>());
    CHECK (robust["field_error"][4].get<double>() < 0.55 * nominal["field_error"][4].get<double>());
    CHECK (robust["as_known"]["field_error"].get<double>() < 0.005);
    CHECK (robust["peak_voltage_V"] <= 50);
}

TEST_CASE ("Options of the tolerance stand with it only and within their bounds", "[command line]")
{
    CHECK (runProgram ({ "design", "--draws", "10" }).exitCode == 2);
    CHECK (runProgram ({ "design", "--tolerance", "--draws", "0" }).exitCode == 2);
    CHECK (runProgram ({ "design", "--tolerance", "--seed", "-1" }).exitCode == 2);

    for (const auto* const value : { "11", "-0.1", "nan" })
    {
        const auto run = runProgram ({ "design", "--tolerance", "--frequency-percent", value });
        CHECK (run.exitCode == 2);
        CHECK (run.errors == "antinode: --frequency-percent: is " + std::string (value) + "; allowed: 0 to 10\n");
    }
}
