#include "Support/DescribedDevices.h"
#include "Support/ErrorText.h"
#include "Support/GridModel.h"
#include "Support/RunProgram.h"
#include "Support/SameModel.h"
#include "Support/SineBeam.h"
#include "Support/TemporaryFolder.h"

#include <antinode_documents/ModeCache.h>

#include <catch2/catch.hpp>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <thread>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace antinode;
using namespace antinode::test;
using test::beam;
using test::isSameToTheBit;
using test::plate;
using test::staple;
namespace fs = std::filesystem;

namespace
{
fs::path onlyFileIn (const fs::path& folder)
{
    std::vector<fs::path> paths;

    for (const auto& entry : fs::directory_iterator (folder))
        paths.push_back (entry.path());

    REQUIRE (paths.size() == 1);
    return paths.front();
}

std::size_t filesIn (const fs::path& folder)
{
    const fs::directory_iterator entries (folder);
    return static_cast<std::size_t> (std::distance (begin (entries), end (entries)));
}

void writeFile (const fs::path& path, std::string_view bytes)
{
    std::ofstream (path, std::ios::binary) << bytes;
}

/** Environment variables for the time of a scope. */
class Environment
{
public:
    Environment()
    {
        for (const auto* const name : { "XDG_CACHE_HOME", "HOME" })
            if (const auto* const value = std::getenv (name))
                before[name] = value;
    }

    ~Environment()
    {
        for (const auto* const name : { "XDG_CACHE_HOME", "HOME" })
            set (name, before.contains (name) ? before[name].c_str() : nullptr);
    }

    Environment (const Environment&) = delete;
    Environment& operator= (const Environment&) = delete;

    static void set (const char* name, const char* value)
    {
        if (value != nullptr)
            setenv (name, value, 1);
        else
            unsetenv (name);
    }

private:
    std::map<std::string, std::string> before;
};
} // namespace

TEST_CASE ("Stored modes come back the same to the bit", "[files][cache]")
{
    const TemporaryFolder scratch;
    const ModeCache cache (scratch.path() / "a" / "b");
    CHECK_FALSE (cache.find (plate(), {}));

    auto odd = test::sineBeam (5, 3); // A line, with slopes.
    odd.rigidBodyModes = 2;
    odd.coversWholeBody = false;
    odd.shapes (0, 0) = -0.0;
    odd.shapes (1, 0) = std::numeric_limits<double>::denorm_min();
    auto bare = test::gridModel (3, 0); // No ceramics.
    bare.frequencyErrors.resize (0);
    bare.name.clear();

    for (const auto& model : { test::gridModel (9, 4), odd, bare })
    {
        cache.store (plate(), {}, model);
        const auto found = cache.find (plate(), {});
        REQUIRE (found);
        CHECK (isSameToTheBit (*found, model));
        CHECK_FALSE (cache.find (plate(), 12)); // The description says 12 too, but that is for the solver to know.
        CHECK_FALSE (cache.find (beam(), {}));
    }

    auto retold = plate();
    retold.description = "The text about a device has no part in its modes";
    CHECK (cache.find (retold, {}));
}

TEST_CASE ("Nobody but the user can read what is stored", "[files][cache]")
{
    const TemporaryFolder scratch;
    const auto folder = scratch.path() / "modes";
    ModeCache (folder).store (plate(), {}, test::gridModel (2, 1));
    CHECK (fs::status (folder).permissions() == fs::perms::owner_all);
    CHECK (fs::status (onlyFileIn (folder)).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE ("A solved device is found the next time, a modal one is not kept, an impossible one throws",
           "[files][cache]")
{
    const TemporaryFolder scratch;
    const ModeCache cache (scratch.path());
    const auto solved = solveCached (staple(), 7, &cache);
    CHECK (isSameToTheBit (solved, solveStructure (staple(), 7)));
    CHECK (isSameToTheBit (solveCached (staple(), 7, &cache), solved));
    CHECK (isSameToTheBit (solveCached (staple(), 7, nullptr), solved));
    CHECK (filesIn (scratch.path()) == 1);

    auto marked = solved; // What is in the cache is what is taken.
    marked.unknowns = 99;
    cache.store (staple(), 7, marked);
    CHECK (solveCached (staple(), 7, &cache).unknowns == 99);
    CHECK (solveCached (staple(), 8, &cache).modes() == 8);

    const DeviceDescription modal { "measured", "", test::gridModel (2, 1) };
    CHECK (solveCached (modal, {}, &cache).modes() == 2);
    auto impossible = staple();
    std::get<StapleDescription> (impossible.body).topLength = -1;
    CHECK_FALSE (errorText ([&] { solveCached (impossible, {}, &cache); }).empty());
    CHECK (filesIn (scratch.path()) == 2);
}

TEST_CASE ("An entry that is cut, changed or foreign is as if it were not there", "[files][cache]")
{
    const TemporaryFolder scratch;
    const ModeCache cache (scratch.path());
    const auto model = test::gridModel (4, 2, 3);
    cache.store (plate(), {}, model);
    const auto path = onlyFileIn (scratch.path());
    const auto good = readContent (path);
    const auto isFound = [&] (std::string_view bytes)
    {
        writeFile (path, bytes);
        return cache.find (plate(), {}).has_value();
    };
    REQUIRE (isFound (good));

    for (std::size_t size = 0; size < good.size(); size += size < 300 ? 1 : 101)
        if (isFound (good.substr (0, size)))
            FAIL_CHECK ("cut to " << size);

    for (std::size_t bit = 0; bit < good.size() * 8; bit += bit < 1600 ? 1 : 211)
    {
        auto changed = good;
        changed[bit / 8] = static_cast<char> (changed[bit / 8] ^ (1 << bit % 8));

        if (isFound (changed))
            FAIL_CHECK ("bit " << bit << " turned");
    }

    CHECK_FALSE (isFound (good + '\0'));
    CHECK_FALSE (isFound (good + good));
    CHECK_FALSE (isFound ("\x89PNG\r\n\x1a\n"));
    CHECK_FALSE (isFound (std::string (good.size(), '\0')));
    CHECK_FALSE (isFound (std::string (good.size(), '\xff')));
    CHECK (isFound (good));

    // What was damaged is written anew.
    writeFile (path, good.substr (0, 100));
    cache.store (plate(), {}, model);
    CHECK (isSameToTheBit (cache.find (plate(), {}).value(), model));
}

TEST_CASE ("An entry under another's name is not taken for it", "[files][cache]")
{
    const TemporaryFolder scratch;
    const ModeCache first (scratch.path() / "1"), second (scratch.path() / "2");
    first.store (plate(), {}, test::gridModel (2, 1));
    second.store (plate(), 5, test::gridModel (3, 1));
    fs::copy_file (onlyFileIn (scratch.path() / "2"), onlyFileIn (scratch.path() / "1"),
                   fs::copy_options::overwrite_existing);
    CHECK_FALSE (first.find (plate(), {}));
    CHECK (second.find (plate(), 5).value().modes() == 3);
}

TEST_CASE ("What lies under an entry's name and is no plain file is let be", "[files][cache]")
{
    const TemporaryFolder scratch;
    const ModeCache cache (scratch.path());
    const auto model = test::gridModel (2, 1);
    cache.store (plate(), {}, model);
    const auto path = onlyFileIn (scratch.path());
    fs::remove (path);
    fs::create_directory (path);
    CHECK_FALSE (cache.find (plate(), {}));
    cache.store (plate(), {}, model);
    CHECK (fs::is_directory (path));
    CHECK (filesIn (scratch.path()) == 1);

    fs::remove (path);
    REQUIRE (mkfifo (path.c_str(), 0600) == 0); // Reading it would wait for ever.
    CHECK_FALSE (cache.find (plate(), {}));
    fs::remove (path);
    fs::create_symlink ("/dev/zero", path);
    CHECK_FALSE (cache.find (plate(), {}));
    fs::remove (path);
    writeFile (path, "");
    fs::resize_file (path, 1000000001); // Sparse. Larger than all entries may be.
    CHECK_FALSE (cache.find (plate(), {}));
}

TEST_CASE ("Where nothing can be written nothing is kept, and nothing is said", "[files][cache]")
{
    const TemporaryFolder scratch;
    writeFile (scratch.path() / "file", "text");

    for (const auto& folder : { scratch.path() / "file", scratch.path() / "file" / "below", fs::path ("/proc/none"),
                                fs::path ("/proc/self"), fs::path() })
    {
        const ModeCache cache (folder);
        CHECK (solveCached (staple(), 3, &cache).modes() == 3);
        CHECK_FALSE (cache.find (staple(), 3));
    }

    CHECK (readContent (scratch.path() / "file") == "text");
}

TEST_CASE ("A full disk leaves nothing behind", "[files][cache]")
{
    const TemporaryFolder scratch;
    const auto folder = scratch.path() / "modes";
    const auto child = fork();

    if (child == 0)
    {
        const rlimit limit { 5000, 5000 }; // A write beyond fails as on a full disk.
        std::signal (SIGXFSZ, SIG_IGN);
        setrlimit (RLIMIT_FSIZE, &limit);
        ModeCache (folder).store (plate(), {}, test::gridModel (9, 4));
        _exit (0);
    }

    int status = 0;
    REQUIRE (waitpid (child, &status, 0) == child);
    CHECK (status == 0);
    CHECK (filesIn (folder) == 0);
}

TEST_CASE ("Threads that store and find at once see whole entries only", "[files][cache]")
{
    const TemporaryFolder scratch;
    const ModeCache cache (scratch.path() / "modes");
    const std::array models { test::gridModel (6, 2), test::gridModel (6, 3) };
    std::atomic<int> wrong = 0, found = 0;
    const auto work = [&] (const ModalModel& own)
    {
        for (int round = 0; round < 40; ++round)
        {
            cache.store (plate(), {}, own);

            if (const auto model = cache.find (plate(), {}))
            {
                ++found;
                wrong += isSameToTheBit (*model, models[0]) || isSameToTheBit (*model, models[1]) ? 0 : 1;
            }
        }
    };
    std::thread other ([&] { work (models[1]); });
    work (models[0]);
    other.join();
    CHECK (wrong == 0);
    CHECK (found == 80);
    CHECK (filesIn (scratch.path() / "modes") == 1);
}

TEST_CASE ("The cache keeps its size: what was not used for the longest time goes first", "[files][cache]")
{
    const TemporaryFolder scratch;
    const auto model = test::gridModel (4, 1);
    ModeCache (scratch.path()).store (plate(), 100, model);
    const auto size = fs::file_size (onlyFileIn (scratch.path()));
    fs::remove (onlyFileIn (scratch.path()));
    const ModeCache cache (scratch.path(), 3 * size + size / 2);
    const auto age = [&] // So that the order does not depend on the clock's step.
    {
        for (const auto& entry : fs::directory_iterator (scratch.path()))
            fs::last_write_time (entry, entry.last_write_time() - std::chrono::hours (1));
    };

    for (int count = 101; count <= 103; ++count, age())
        cache.store (plate(), count, model);

    CHECK (cache.find (plate(), 101)); // Used: now the youngest.
    writeFile (scratch.path() / "notes.txt", std::string (5 * size, 'x'));
    age();
    cache.store (plate(), 104, model);
    CHECK (cache.find (plate(), 101));
    CHECK_FALSE (cache.find (plate(), 102));
    CHECK (cache.find (plate(), 103));
    CHECK (cache.find (plate(), 104));
    CHECK (fs::exists (scratch.path() / "notes.txt"));

    cache.store (plate(), 105, test::gridModel (40, 1)); // Alone more than all may take.
    CHECK_FALSE (cache.find (plate(), 105));
    CHECK (cache.find (plate(), 104));
}

TEST_CASE ("The user's cache is where the base directory specification puts it", "[files][cache]")
{
    const Environment restored;
    Environment::set ("HOME", "/home/somebody");
    Environment::set ("XDG_CACHE_HOME", "/var/somewhere");
    CHECK (userCacheFolder() == "/var/somewhere/antinode/modes");

    for (const auto* const unset : { static_cast<const char*> (nullptr), "", "relative/path" })
    {
        Environment::set ("XDG_CACHE_HOME", unset);
        CHECK (userCacheFolder() == "/home/somebody/.cache/antinode/modes");
    }

    Environment::set ("HOME", nullptr);
    CHECK_FALSE (userCacheFolder());
}
