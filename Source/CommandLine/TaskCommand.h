#pragma once

#include <antinode_base/Progress.h>
#include <antinode_tasks/Field.h>

#include <CLI/CLI.hpp>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** Reads the devices, focuses, waveforms and places that options named, once; to be called before the task. */
struct ReadFields
{
    std::function<void()> read;
    std::shared_ptr<const std::vector<std::string>> assignments; ///< The values of --set.

    void operator()() const { read(); }
};

/** Adds the fields of a request to a sub-command as options, and --set where they name documents. What they point to
   must live as long as the app. [worker] */
ReadFields addFields (CLI::App&, const std::vector<Field>&);

/** A line of progress with the time left on a terminal, for work that takes more than a second. Silent elsewhere. */
class Progress
{
public:
    /** @param isQuiet  never shows anything */
    explicit Progress (bool isQuiet);

    /** Wipes its line. */
    ~Progress();
    Progress (const Progress&) = delete;
    Progress& operator= (const Progress&) = delete;

    /** Shows what is being done, how much of it, and how long the rest will take.
        @param what    what is being done
        @param share   0 to 1 of it
        @param detail  more words, for example "12 of 46"; may be empty
        [worker] from one thread at a time */
    void show (const std::string& what, double share, const std::string& detail = {});

    /** show() as a function, which must not outlive it. */
    ShowProgress shown()
    {
        return [this] (const std::string& what, double share) { show (what, share); };
    }

private:
    bool isOn;
    bool hasShown = false;
    std::string current;
    TimeLeft left;
    std::chrono::steady_clock::time_point start, last;
};

/** Adds a sub-command whose task writes a folder: the fields of its request, --out and --quiet. It shows progress,
   writes the result, and prints it unless it is quiet.
    @param write  of the folder and the result
    @param print  of the result and the name of the folder
    @param more   fields of the command line only
    [worker] */
template <typename Request, typename Result, typename Write, typename Print>
CLI::App& addFolderTask (CLI::App& app, const TaskText& text, const char* usualFolder,
                         Result (*task) (const Request&, const ShowProgress&), const Write& write, const Print& print,
                         std::vector<Field> (*more) (Request&) = nullptr)
{
    struct Options
    {
        Request request;
        std::filesystem::path folder;
        bool isQuiet = false;
    };

    auto* const command = app.add_subcommand (text.name, text.summary);
    auto options = std::make_shared<Options>();
    options->folder = usualFolder;
    auto all = fields (options->request);

    if (more != nullptr)
        append (all, more (options->request));

    append (all, { Field ("--out", &options->folder, "Output folder"), quietField (options->isQuiet) });
    command->callback (
        [options, task, write, print, read = addFields (*command, all)]
        {
            read();
            Progress progress (options->isQuiet);
            const auto result = task (options->request, progress.shown());
            write (options->folder, result);

            if (! options->isQuiet)
                print (result, options->folder.string());
        });
    return *command;
}
} // namespace antinode
