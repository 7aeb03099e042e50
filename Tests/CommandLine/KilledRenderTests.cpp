#include "Support/RunProgram.h"

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <thread>

using namespace antinode;

namespace
{
/** Whether every visible file of a result folder is whole. */
void checkWhole (const std::filesystem::path& folder)
{
    for (const auto& entry : std::filesystem::directory_iterator (folder))
    {
        const auto name = entry.path().filename().string();

        if (name.starts_with ("."))
            continue;

        const auto content = test::readContent (entry.path());
        INFO (name);

        if (name.ends_with (".json"))
            CHECK (nlohmann::json::accept (content));
        else if (name.ends_with (".html"))
            CHECK_THAT (content, Catch::Contains ("</html>"));
        else if (name.ends_with (".wav"))
            CHECK (content.size()
                   == 8 + static_cast<std::size_t> (static_cast<unsigned char> (content[4]))
                          + (static_cast<std::size_t> (static_cast<unsigned char> (content[5])) << 8)
                          + (static_cast<std::size_t> (static_cast<unsigned char> (content[6])) << 16)
                          + (static_cast<std::size_t> (static_cast<unsigned char> (content[7])) << 24));
        else
            CHECK_FALSE (content.empty());
    }

    // summary.json comes last: where it is, everything is.
    if (std::filesystem::exists (folder / "summary.json"))
        for (const auto* name : { "voltages.wav", "probe.csv", "design.json", "report.html" })
            CHECK (std::filesystem::exists (folder / name));
}
} // namespace

TEST_CASE ("A render that is killed at any moment leaves nothing half-written, and the next one cleans up",
           "[command line]")
{
    using namespace std::chrono;
    const TemporaryFolder folder, streams;
    const auto out = folder.path() / "out";
    const test::ProgramArguments render { "render", "--quiet", "--out", out };
    const auto begin = steady_clock::now();
    REQUIRE (test::waitForProgram (test::startProgram (render, streams.path())) == 0);
    const auto whole = steady_clock::now() - begin;
    std::filesystem::remove_all (out);
    constexpr int moments = 24;

    for (int i = 0; i < moments; ++i)
    {
        const auto program = test::startProgram (render, streams.path());
        std::this_thread::sleep_for (whole * i / moments);
        kill (program, SIGKILL);
        test::waitForProgram (program);

        if (std::filesystem::exists (out))
            checkWhole (out);
    }

    REQUIRE (test::waitForProgram (test::startProgram (render, streams.path())) == 0);
    checkWhole (out);

    for (const auto& entry : std::filesystem::directory_iterator (out))
        CHECK_FALSE (entry.path().filename().string().starts_with ("."));
}

TEST_CASE ("A render that is interrupted at any moment ends with 130, says so, and leaves nothing", "[command line]")
{
    using namespace std::chrono;
    const TemporaryFolder folder, streams;
    const auto out = folder.path() / "out";
    const test::ProgramArguments render { "render", "--quiet", "--no-cache", "--out", out };
    const auto begin = steady_clock::now();
    REQUIRE (test::waitForProgram (test::startProgram (render, streams.path())) == 0);
    const auto whole = steady_clock::now() - begin;
    std::filesystem::remove_all (out);
    constexpr int moments = 12;
    constexpr int interrupted = 128 + SIGINT;

    // Not at its very begin: before the program looks at signals it ends by them, and says nothing.
    for (int i = 2; i < moments; ++i)
    {
        const auto program = test::startProgram (render, streams.path());
        std::this_thread::sleep_for (whole * i / moments);
        kill (program, SIGINT);

        if (test::waitForProgram (program) == interrupted)
        {
            CHECK (test::readContent (streams.path() / "stderr") == "Interrupted\n");
            CHECK_FALSE (std::filesystem::exists (out));
        }
        else
        {
            checkWhole (out);
            std::filesystem::remove_all (out);
        }
    }
}

TEST_CASE ("place that is interrupted keeps the best places so far, in a device and as a row", "[command line]")
{
    constexpr int interrupted = 128 + SIGINT;
    const TemporaryFolder folder, streams;
    const auto out = folder.path() / "few-8.json";
    const auto program = test::startProgram ({ "place", "aluminium-200x120", "--focus", "aluminium-centre", "--counts",
                                               "8,12", "--out", folder.path() / "few.json" },
                                             streams.path());

    for (int i = 0; i < 20000 && ! std::filesystem::exists (out); ++i) // a program that ends before has none
        std::this_thread::sleep_for (std::chrono::milliseconds (5));

    kill (program, SIGINT);
    CHECK (test::waitForProgram (program) == interrupted);
    CHECK (nlohmann::json::parse (test::readContent (out))["ceramics"].size() == 8);
    CHECK_THAT (test::readContent (streams.path() / "stdout"), Catch::Contains ("the best so far"));
    CHECK_THAT (test::readContent (folder.path() / "few.csv"), Catch::Contains ("\nfew-8,8,"));
    CHECK_FALSE (std::filesystem::exists (folder.path() / "few-12.json"));
}
