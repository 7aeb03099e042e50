#include "Support/BrokenFiles.h"
#include "Support/RunProgram.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace antinode;

TEST_CASE ("Three hundred and more broken files each end the program with 1 and one line that names the file",
           "[command line]")
{
    const TemporaryFolder folder;
    const auto all = brokenFiles();
    const auto stride = all.size() / 330;
    std::size_t tried = 0;

    for (std::size_t i = 0; i < all.size(); i += std::max<std::size_t> (stride, 1))
    {
        const auto file = folder.path() / "broken.json";
        std::ofstream (file, std::ios::binary) << all[i].bytes;
        const auto run = all[i].isFocus ? test::runProgram ({ "design", file, "--out", folder.path() / "out" })
                                        : test::runProgram ({ "modes", file });
        INFO (all[i].name << ": " << run.errors);
        REQUIRE (run.exitCode == 1);
        REQUIRE (std::count (run.errors.begin(), run.errors.end(), '\n') == 1);
        REQUIRE_THAT (run.errors, Catch::Contains ("broken.json"));
        ++tried;
    }

    CHECK (tried >= 300);
    CHECK_FALSE (std::filesystem::exists (folder.path() / "out"));
}
