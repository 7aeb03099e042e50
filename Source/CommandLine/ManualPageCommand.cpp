#include "Commands.h"

#include <antinode_base/InputError.h>
#include <antinode_base/WholeFile.h>

#include <cstdio>
#include <map>
#include <memory>
#include <sstream>

namespace antinode
{
namespace
{
/** Text as roff takes it. */
std::string roff (const std::string& text)
{
    std::string escaped;

    for (const auto letter : text)
        escaped += letter == '-' ? "\\-" : letter == '\\' ? "\\e" : std::string (1, letter);

    return escaped.starts_with ('.') || escaped.starts_with ('\'') ? "\\&" + escaped : escaped;
}

std::string optionInRoff (const CLI::Option& option)
{
    const auto name = roff ("--" + option.get_lnames().front());
    auto text = roff (option.get_description());

    if (! option.get_default_str().empty())
        text += "; default: " + roff (option.get_default_str());

    const auto head =
        option.get_expected_max() == 0 ? ".B " + name : ".BI " + name + " \" " + roff (option.get_type_name()) + "\"";
    return ".TP\n" + head + "\n" + text + ".\n";
}

/** A page in which each command has its prose, ".SS antinode NAME ...", with the options behind it, in the order of
   --help.
    @throws InputError  where one has no prose */
std::string wholePage (const CLI::App& app, const std::string& page)
{
    std::map<std::string, std::string> prose;
    std::istringstream lines (page);
    std::string line, head, tail, *part = &head;
    const std::string begin = ".SS antinode ";

    while (std::getline (lines, line))
    {
        if (line.starts_with (begin))
            part = &prose[line.substr (begin.size(), line.find (' ', begin.size()) - begin.size())];
        else if (line.starts_with (".SH") && part != &head)
            part = &tail;

        *part += line + "\n";
    }

    for (const auto* const command :
         app.get_subcommands ([] (const CLI::App* each) { return ! each->get_group().empty(); }))
    {
        if (! prose.contains (command->get_name()))
            throw InputError ("manual page", "does not describe the command '" + command->get_name() + "'");

        head += prose[command->get_name()];

        for (const auto* const option : command->get_options())
            if (! option->get_lnames().empty() && option->get_lnames().front() != "help")
                head += optionInRoff (*option);
    }

    return head + tail;
}
} // namespace

void addManualPageCommand (CLI::App& app)
{
    auto* command =
        app.add_subcommand ("manual-page", "Adds the options of all commands to a page for man")->group ({});
    auto file = std::make_shared<std::string>();
    command->add_option ("file", *file, "Page that describes each command")->required();
    command->callback ([&app, file]
                       { std::fputs (wholePage (app, readWholeFile (*file, { "a page for man" })).c_str(), stdout); });
}
} // namespace antinode
