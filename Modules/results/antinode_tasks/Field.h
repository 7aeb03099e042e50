#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace antinode
{
struct DesignedFocus;
struct DeviceDescription;
struct ExcitationSheet;
struct FocusDescription;
struct WaveformsDescription;

/** Numbers that belong together: on the command line one text, "300:4000", in Python a tuple. */
struct NumberRows
{
    std::string allowed;                                   ///< In words: "two ascending numbers, for example 300:4000".
    std::size_t least = 2, most = 2;                       ///< How many numbers.
    bool repeats = true;                                   ///< Several rows; else one.
    std::function<void (const std::vector<double>&)> take; ///< Is given each row.
};

/** Texts of the command line only, which may be given again and again. */
struct TextRows
{
    std::function<void (const std::string&)> take; ///< Is given each.
};

/** A focus; of Python a design in its place, too. */
struct FocusOrDesign
{
    FocusDescription* focus = nullptr;
    std::shared_ptr<const DesignedFocus>* design = nullptr;
};

/** A focus; on the command line several in its place, by name, the first of which is read. */
struct FocusSeries
{
    FocusDescription* focus = nullptr;
    std::vector<std::string>* names = nullptr;
};

/** A device or none. */
struct OptionalDevice
{
    std::optional<DeviceDescription>* device = nullptr;
};

/** Waveforms or none. */
struct OptionalWaveforms
{
    std::optional<WaveformsDescription>* waveforms = nullptr;
};

/** The sheet of an excitation or none, of Python only. */
struct OptionalSheet
{
    std::optional<ExcitationSheet>* sheet = nullptr;
};

/** On the command line a flag that gives a text this word. */
struct WordFlag
{
    std::optional<std::string>* text = nullptr;
    std::string word;
};

/** Plays voltages (N_b x N_s, V) in a pass (from 0) and gives what sensors heard meanwhile (sensors x samples). */
using PlayFunction = std::function<Eigen::MatrixXd (const Eigen::MatrixXd& voltages, int pass)>;

/** Where a field keeps what it is given: a member of a request. An empty path is none. */
using FieldValue =
    std::variant<bool*, int*, std::optional<int>*, std::uint64_t*, double*, std::optional<double>*, std::string*,
                 std::optional<std::string>*, std::filesystem::path*, std::vector<std::string>*,
                 std::vector<std::filesystem::path>*, std::vector<double>*, std::vector<int>*, NumberRows, TextRows,
                 WordFlag, Eigen::MatrixX2d*, std::optional<Eigen::MatrixXd>*, PlayFunction*, DeviceDescription*,
                 std::vector<DeviceDescription>*, OptionalDevice, FocusDescription*, FocusOrDesign, FocusSeries,
                 std::vector<FocusDescription>*, WaveformsDescription*, OptionalWaveforms, OptionalSheet>;

/** A field of a request, described once: the options of the command line, --help, the man page, and the keywords,
   checks, docstrings and types of Python are made of it. [any] */
struct Field
{
    /** @param optionName  "--place-mm"; a word without dashes: a position; empty: not on the command line
        @param sentence    a noun phrase or an imperative with the unit, without the default */
    Field (std::string optionName, FieldValue, std::string sentence);

    std::string option;
    std::string keyword; ///< Of Python, "place_mm"; empty: not there.
    FieldValue value;
    std::string text;
    std::string otherwise;                    ///< What counts where it is not given; empty: the value that is there.
    std::string form;                         ///< How it is written on the command line, "FILE"; empty: by its type.
    std::string usual;                        ///< Of a document: the name of the one that counts where none is given.
    double perUnit = 1;                       ///< Numbers are kept in SI units: divided by this.
    char separator = 0;                       ///< Of a list, or of the numbers of a row, on the command line.
    std::vector<std::string> words;           ///< Those that are allowed; empty: any.
    std::vector<std::string> needs, excludes; ///< Other options.
    std::optional<std::pair<double, double>> range; ///< What is allowed, in the unit of the boundary.
    bool isRequired = false;
    bool isPositional = false; ///< In Python, too, it may be given without its name.

    Field& as (std::string name);  ///< Another keyword; empty: none.
    Field& in (double unitsPerSi); ///< 100 for %, 1000 for mm.
    Field& within (double least, double most);
    Field& positive();
    Field& oneOf (std::vector<std::string>);
    Field& by (std::string reason); ///< Sets `otherwise`.
    Field& written (std::string text, char separatedBy = 0);
    Field& usually (std::string document); ///< Sets `usual`.
    Field& required();
    Field& positional();
    Field& with (std::string optionName);    ///< Needs it.
    Field& without (std::string optionName); ///< Excludes it.

    /** Whether the value that is there is told as the default. */
    bool showsDefault() const { return otherwise.empty() && ! isRequired; }
};

/** Of a number as many digits as are worth showing. [any] */
std::string fieldNumber (double);

/** Why a number, in the unit of the boundary, or a word is refused: "is 0; allowed: 1 to 50"; empty: it is allowed.
 * [any]
 */
std::string refusalOf (const Field&, double given);
std::string refusalOf (const Field&, const std::string& given);

/** "0 to 50", "above 0", "from 0": what is allowed, in the unit of the boundary. [any] */
std::string rangeInWords (const std::pair<double, double>& range);

/** The flag that bypasses the user's cache of solved devices; `cache=False`. [any] */
Field cacheField (bool& usesCache);

/** "--quiet", of the command line only. [any] */
Field quietField (bool& isQuiet);

/** Adds fields behind others. [any] */
void append (std::vector<Field>&, std::vector<Field>);

/** What all ways in say of a task. */
struct TaskText
{
    const char* name;    ///< Of the command and of the function of Python.
    const char* summary; ///< What it does, in the third person.
    const char* source;  ///< Of the theory.
};

/** An error of a lower module in the words of this program: the fields that it names become keys and options, for
    example "focus: target 1 x: is 200 mm" becomes "focus: /targets/0/x_mm: is 200 mm". Other text stays. [any] */
std::string withKeysAndOptions (std::string message);
} // namespace antinode
