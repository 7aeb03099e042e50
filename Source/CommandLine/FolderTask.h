#pragma once

#include "FieldOptions.h"
#include "Progress.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace antinode
{
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
