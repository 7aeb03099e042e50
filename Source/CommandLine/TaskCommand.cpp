#include "TaskCommand.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/System.h>
#include <antinode_documents/ExcitationFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_responses/PointsFile.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

namespace antinode
{
namespace
{
/** What the options of a sub-command name, until it is read. */
struct NamedDocuments
{
    std::vector<std::string> assignments, readers; ///< Values of --set; names of focuses or waveforms.
    LibraryKind kind = LibraryKind::focus;         ///< Of the latter.
    std::vector<std::function<void()>> reads;      ///< Of all but devices: focuses may name those.
    std::vector<std::function<void()>> readsAfter; ///< Of devices.
};

[[noreturn]] void failDevices (const std::string& focus, const std::string& device, const std::string& otherFocus,
                               const std::string& otherDevice)
{
    throw InputError (focus, "is for the device '" + device + "', and " + otherFocus + " for '" + otherDevice
                                 + "'; allowed: one device for all, or --device");
}

/** The device of all these focuses. @param usual  where none is named
    @throws InputError  where they name different ones */
std::string deviceFor (LibraryKind kind, const std::vector<std::string>& documents, const std::string& given,
                       const std::string& usual, const std::vector<std::string>& assignments)
{
    if (! given.empty())
        return given;

    std::string device, first;

    for (const auto& document : documents)
    {
        const auto named = namedDevice (kind, document, assignments);

        if (! named.empty() && ! device.empty() && named != device)
            failDevices (documentSource (kind, document), named, first, device);

        if (device.empty() && ! named.empty())
        {
            device = named;
            first = documentSource (kind, document);
        }
    }

    return device.empty() ? usual : device;
}

/** "300:4000" as numbers. @throws InputError  naming the option, unless there are as many as are allowed */
std::vector<double> numbersOf (const Field& field, const NumberRows& rows, const std::string& text)
{
    std::vector<double> numbers;
    const auto* at = text.data();
    const auto* const end = at + text.size();

    while (true)
    {
        const auto [next, error] = std::from_chars (at, end, numbers.emplace_back());

        if (error != std::errc() || (next != end && *next != field.separator) || numbers.size() > rows.most)
            break;

        if (next != end)
        {
            at = next + 1;
            continue;
        }

        if (numbers.size() < rows.least)
            break;

        return numbers;
    }

    throw InputError (field.option, "is " + inQuotes (text) + "; allowed: " + rows.allowed);
}

template <typename Given>
void check (const Field& field, const Given& given)
{
    if (const auto refusal = refusalOf (field, given); ! refusal.empty())
        throw CLI::ValidationError (field.option, refusal);
}

/** Adds one field, by what keeps it. */
class FieldAdder
{
public:
    FieldAdder (CLI::App& app, Field added, std::shared_ptr<NamedDocuments> named)
        : command (app), field (std::move (added)), documents (std::move (named)),
          text (field.otherwise.empty() ? field.text : field.text + "; default: " + field.otherwise)
    {
    }

    CLI::Option* operator() (bool* value) const
    {
        return command.add_flag_callback (
            field.option, [value, given = ! *value] { *value = given; }, text);
    }

    CLI::Option* operator() (int* value) const
    {
        return number<int> ([value] (int given) { *value = given; }, *value);
    }

    CLI::Option* operator() (std::uint64_t* value) const
    {
        return number<std::uint64_t> ([value] (std::uint64_t given) { *value = given; }, *value);
    }

    CLI::Option* operator() (double* value) const
    {
        return number<double> ([value, per = field.perUnit] (double given) { *value = given / per; },
                               *value * field.perUnit);
    }

    CLI::Option* operator() (std::optional<int>* value) const
    {
        return number<int> ([value] (int given) { *value = given; }, {});
    }

    CLI::Option* operator() (std::optional<double>* value) const
    {
        return number<double> ([value, per = field.perUnit] (double given) { *value = given / per; }, {});
    }

    CLI::Option* operator() (std::string* value) const
    {
        auto* const option = word ([value] (const std::string& given) { *value = given; });
        return field.showsDefault() && ! value->empty() ? option->default_str (*value) : option;
    }

    CLI::Option* operator() (std::optional<std::string>* value) const
    {
        return word (
            [value] (const std::string& given)
            {
                if (! given.empty()) // Else it says nothing.
                    *value = given;
            });
    }

    CLI::Option* operator() (std::filesystem::path* value) const
    {
        auto* const option = word ([value] (const std::string& given) { *value = given; });
        return value->empty() ? option : option->default_str (value->string());
    }

    CLI::Option* operator() (std::vector<std::string>* value) const
    {
        return choosing (list (command.add_option_function<std::vector<std::string>> (
            field.option,
            [value, which = field] (const std::vector<std::string>& given)
            {
                for (const auto& each : given)
                    check (which, each);

                *value = given;
            },
            text)));
    }

    CLI::Option* operator() (std::vector<std::filesystem::path>* value) const
    {
        return list (command.add_option_function<std::vector<std::string>> (
            field.option, [value] (const auto& given) { value->assign (given.begin(), given.end()); }, text));
    }

    CLI::Option* operator() (std::vector<double>* value) const { return numbers (value); }
    CLI::Option* operator() (std::vector<int>* value) const { return numbers (value); }

    CLI::Option* operator() (const NumberRows& rows) const
    {
        const auto take = [rows, which = field] (const std::vector<std::string>& given)
        {
            for (const auto& each : given)
                rows.take (numbersOf (which, rows, each));
        };

        if (! rows.repeats)
            return word (
                [take] (const std::string& given)
                {
                    if (! given.empty())
                        take ({ given });
                });

        return command.add_option_function<std::vector<std::string>> (field.option, take, text)
            ->allow_extra_args (false);
    }

    CLI::Option* operator() (const TextRows& rows) const
    {
        return command
            .add_option_function<std::vector<std::string>> (
                field.option,
                [rows] (const std::vector<std::string>& given)
                {
                    for (const auto& each : given)
                        rows.take (each);
                },
                text)
            ->allow_extra_args (false);
    }

    CLI::Option* operator() (const FocusOrDesign& value) const { return (*this) (value.focus); }

    CLI::Option* operator() (const FocusSeries& value) const
    {
        documents->kind = LibraryKind::focus;
        *value.names = { field.usual };
        documents->reads.push_back (
            [value, named = documents]
            {
                named->readers = *value.names;
                *value.focus = loadFocus (named->readers.front(), named->assignments);
            });
        return command.add_option (field.option, *value.names, text)->capture_default_str();
    }

    CLI::Option* operator() (const WordFlag& flag) const
    {
        return command.add_flag_callback (
            field.option, [flag] { *flag.text = flag.word; }, text);
    }

    CLI::Option* operator() (Eigen::MatrixX2d* value) const
    {
        const auto keep = [value, named = documents] (const std::string& file)
        {
            if (! file.empty())
                named->reads.push_back ([value, file] { *value = readPointsFile (file); });
        };
        return word (keep)->description ("CSV of x and y, mm: " + text);
    }

    CLI::Option* operator() (DeviceDescription* value) const
    {
        auto name = std::make_shared<std::string> (field.otherwise.empty() ? field.usual : "");
        auto* const option = command.add_option (field.option, *name, text);

        if (! name->empty())
            option->capture_default_str();

        const auto mayBeEmpty = ! field.otherwise.empty();
        documents->readsAfter.push_back (
            [value, name, option, mayBeEmpty, usual = field.usual, named = documents]
            {
                const auto isGiven = option->count() > 0 && ! (mayBeEmpty && name->empty());
                *value = loadDevice (
                    isGiven ? *name : deviceFor (named->kind, named->readers, *name, usual, named->assignments),
                    named->assignments);
            });
        return option;
    }

    CLI::Option* operator() (std::vector<DeviceDescription>* value) const
    {
        return list (command.add_option_function<std::vector<std::string>> (
            field.option,
            [value, named = documents] (const std::vector<std::string>& names)
            {
                for (const auto& name : names)
                    named->readsAfter.push_back ([value, name, named]
                                                 { value->push_back (loadDevice (name, named->assignments)); });
            },
            text));
    }

    CLI::Option* operator() (const OptionalDevice& value) const
    {
        return word (
            [value, named = documents] (const std::string& name)
            {
                if (! name.empty())
                    named->readsAfter.push_back ([value, name] { *value.device = loadDevice (name, {}); });
            });
    }

    CLI::Option* operator() (FocusDescription* value) const
    {
        return document (LibraryKind::focus, [value, named = documents] (const std::string& name)
                         { *value = loadFocus (name, named->assignments); });
    }

    CLI::Option* operator() (WaveformsDescription* value) const
    {
        return document (LibraryKind::waveforms, [value, named = documents] (const std::string& name)
                         { *value = loadWaveforms (name, named->assignments); });
    }

    CLI::Option* operator() (const OptionalWaveforms& value) const
    {
        return word (
            [value, named = documents] (const std::string& name)
            {
                if (! name.empty())
                    named->reads.push_back ([value, name, named]
                                            { *value.waveforms = loadWaveforms (name, named->assignments); });
            });
    }

    CLI::Option* operator() (std::vector<FocusDescription>* value) const
    {
        return list (command.add_option_function<std::vector<std::string>> (
            field.option,
            [value, named = documents] (const std::vector<std::string>& names)
            {
                for (const auto& name : names)
                    named->reads.push_back ([value, name, named]
                                            { value->push_back (loadFocus (name, named->assignments)); });
            },
            text));
    }

    // These are Python's only.
    CLI::Option* operator() (std::optional<Eigen::MatrixXd>*) const { return nullptr; }
    CLI::Option* operator() (PlayFunction*) const { return nullptr; }
    CLI::Option* operator() (const OptionalSheet&) const { return nullptr; }

private:
    template <typename Number, typename Keep>
    CLI::Option* number (const Keep& keep, std::optional<Number> usual) const
    {
        auto* const option = command.add_option_function<Number> (
            field.option,
            [keep, which = field] (const Number& given)
            {
                check (which, static_cast<double> (given));
                keep (given);
            },
            text);

        if (field.range)
            option->type_name (option->get_type_name() + " " + rangeInWords (*field.range));

        if (usual && field.showsDefault())
            option->default_str (fieldNumber (static_cast<double> (*usual)));

        return option;
    }

    template <typename Number>
    CLI::Option* numbers (std::vector<Number>* value) const
    {
        return list (command.add_option_function<std::vector<Number>> (
            field.option,
            [value, which = field] (const std::vector<Number>& given)
            {
                for (const auto each : given)
                    check (which, static_cast<double> (each));

                *value = given;
            },
            text));
    }

    CLI::Option* word (const std::function<void (const std::string&)>& keep) const
    {
        return choosing (command.add_option_function<std::string> (
            field.option,
            [keep, which = field] (const std::string& given)
            {
                check (which, given);
                keep (given);
            },
            text));
    }

    /** A focus or waveforms by name or file. */
    CLI::Option* document (LibraryKind kind, const std::function<void (const std::string&)>& read) const
    {
        documents->kind = kind;
        documents->readers = { field.usual };
        documents->reads.push_back ([read, named = documents] { read (named->readers.front()); });
        return command.add_option (field.option, documents->readers.front(), text)->capture_default_str();
    }

    CLI::Option* list (CLI::Option* option) const
    {
        if (field.separator != 0)
            return option->delimiter (field.separator);

        return field.option.starts_with ("-") ? option->allow_extra_args (false) : option;
    }

    /** With the words that are allowed, as completion reads them. */
    CLI::Option* choosing (CLI::Option* option) const
    {
        return field.words.empty() ? option : option->type_name ("TEXT:{" + CLI::detail::join (field.words, ",") + "}");
    }

    CLI::App& command;
    Field field;
    std::shared_ptr<NamedDocuments> documents;
    std::string text;
};

void addAssignments (CLI::App& command, std::vector<std::string>& assignments, const std::string& example)
{
    command.add_option ("--set", assignments, "Overrides a key, for example " + example + " (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("KEY=VALUE");
}
} // namespace

ReadFields addFields (CLI::App& command, const std::vector<Field>& fields)
{
    auto documents = std::make_shared<NamedDocuments>();
    std::string example;

    for (const auto& field : fields)
    {
        if (field.option.empty())
            continue;

        auto* const option = std::visit (FieldAdder (command, field, documents), field.value);

        if (! field.form.empty())
            option->type_name (field.form);

        if (field.isRequired)
            option->required();

        for (const auto& other : field.needs)
            option->needs (command.get_option (other));

        for (const auto& other : field.excludes)
            option->excludes (command.get_option (other));

        if (std::holds_alternative<FocusDescription*> (field.value)
            || std::holds_alternative<FocusSeries> (field.value))
            example = "focus.targets.0.x_mm=24";
        else if (std::holds_alternative<WaveformsDescription*> (field.value))
            example = "waveforms.tracks.0.x_mm=24";
        else if ((std::holds_alternative<DeviceDescription*> (field.value)
                  || std::holds_alternative<std::vector<DeviceDescription>*> (field.value))
                 && example.empty())
            example = "device.thickness_mm=1.5";
    }

    if (! example.empty())
        addAssignments (command, documents->assignments, example);

    return { [documents]
             {
                 checkAssignments (documents->assignments);

                 for (const auto* const reads : { &documents->reads, &documents->readsAfter })
                     for (const auto& read : *reads)
                         read();
             },
             { documents, &documents->assignments } };
}

using namespace std::chrono_literals;

Progress::Progress (bool isQuiet)
    : isOn (! isQuiet && errorsGoToTerminal()), start (std::chrono::steady_clock::now()), last (start)
{
}

Progress::~Progress()
{
    if (hasShown)
        std::fputs ("\r\033[K", stderr);
}

void Progress::show (const std::string& what, double share, const std::string& detail)
{
    if (std::exchange (current, what) != what)
        left = TimeLeft (share);

    const auto now = std::chrono::steady_clock::now();

    if (! isOn || now - start < 1s || now - last < 100ms)
        return;

    auto line = formatted ("%s %3ld %%", what.c_str(), std::lround (100 * share));

    for (const auto& more : { detail, left.at (share) })
        if (! more.empty())
            line += ", " + more;

    std::fprintf (stderr, "\r\033[K%s", line.c_str());
    std::fflush (stderr);
    hasShown = true;
    last = now;
}
} // namespace antinode
