#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace antinode
{
// The data sets of Universal Files, as they stand in the file: in the file's units, with the format's own codes for
// kinds and quantities. SDRC universal data sets, https://www.ceas3.uc.edu/sdrluff.
using UniversalLabel = std::int64_t;

/** The storage of the numbers of a function in the file. */
enum class UniversalEncoding
{
    text,
    littleEndian,
    bigEndian
};

/** A point that is driven or moves: node and direction; +-1, 2, 3 are along and against x, y, z, +-4 to 6 turn about
    them. */
struct UniversalPlace
{
    std::string entity = "NONE";
    UniversalLabel node = 0;
    int direction = 0;
};

/** The content of an axis of a function. */
struct UniversalAxis
{
    int quantity = 0; ///< Code: 8 displacement, 11 velocity, 12 acceleration, 13 force, 17 time, 18 frequency ...
    std::array<int, 3> exponents {}; ///< Of length, force and temperature in its unit.
    std::string label = "NONE", unit = "NONE";
};

/** 58 and 58b: a function at a point. */
struct UniversalFunction
{
    UniversalEncoding encoding = UniversalEncoding::text;
    std::array<std::string, 5> lines; ///< Text lines.
    int functionType = 0; ///< 1 time, 2 auto spectrum, 3 cross spectrum, 4 frequency response, 6 coherence, 9 density.
    UniversalLabel identification = 0, version = 0, loadCase = 0;
    UniversalPlace response, reference;
    int ordinateType = 2;           ///< 2 real and 5 complex in single, 4 and 6 in double precision.
    UniversalLabel statedCount = 0; ///< The number of values according to the header; the values are the actual ones.
    bool isEven = true;
    double first = 0, step = 0, z = 0; ///< Abscissa of the first value and from value to value, where it is even.
    UniversalAxis abscissa, ordinate, denominator, zAxis;
    Eigen::VectorXd abscissae; ///< One for each value where it is uneven, else empty.
    Eigen::VectorXcd values;   ///< Of real ones the imaginary part is 0.

    bool isComplex() const { return ordinateType >= 5; }
    bool isDouble() const { return ordinateType % 2 == 0 && ordinateType != 2; }
};

/** 55: data at nodes, a mode shape for example. N nodes, V values each. */
struct UniversalShape
{
    std::array<std::string, 5> lines;
    int modelType = 1, analysisType = 0; ///< Analysis: 2 normal mode, 3 and 7 complex eigenvalue, 5 frequency response.
    int dataCharacteristic = 2;          ///< 1 scalar, 2 translations, 3 translations and rotations.
    int specificType = 8;                ///< As UniversalAxis::quantity.
    bool isComplex = false;
    std::vector<UniversalLabel> integers; ///< Of a mode: load case, mode number.
    std::vector<double> reals; ///< Of a normal mode: Hz, modal mass, viscous and hysteretic damping ratio; of a complex
                               ///< one first its eigenvalue, 1/s.
    std::vector<UniversalLabel> nodes;
    Eigen::MatrixXcd values; ///< N x V
};

/** 15 and 2411: nodes. */
struct UniversalNodes
{
    bool isDouble = true;                               ///< 2411.
    std::vector<UniversalLabel> labels;                 ///< N
    std::vector<std::array<UniversalLabel, 3>> systems; ///< N: of definition, of displacement, colour.
    Eigen::MatrixX3d places;                            ///< N x 3, in the file's unit of length.
};

/** 82: a line drawn through nodes; a 0 lifts the pen. */
struct UniversalTrace
{
    UniversalLabel number = 0, colour = 0;
    std::string text;
    std::vector<UniversalLabel> nodes;
};

/** 151: who made the model, when and with what; its lines as they stand. */
struct UniversalHeader
{
    std::vector<std::string> lines;
};

/** 164: units. What stands in the file divided by a factor is in SI units. */
struct UniversalUnits
{
    int code = 1;
    std::string description;
    int temperatureMode = 0;                       ///< 1 absolute, 2 relative, 0 not said.
    double length = 1, force = 1, temperature = 1; ///< Factors.
    double temperatureOffset = 0;
};

/** One element of a mesh. */
struct UniversalElement
{
    std::array<UniversalLabel, 5> head {}; ///< Label, kind (FE descriptor), physical and material property, colour.
    std::vector<UniversalLabel> beam;      ///< Of beams: orientation node and end cross-sections; else empty.
    std::vector<UniversalLabel> nodes;
};

/** 2412: elements. */
struct UniversalElements
{
    std::vector<UniversalElement> elements;
};

/** Values at one place of an analysis. */
struct UniversalResult
{
    std::vector<UniversalLabel> head; ///< Its node; or its element and how many values; or four integers.
    Eigen::VectorXcd values;
};

/** 2414: the data of an analysis. */
struct UniversalResults
{
    UniversalLabel label = 0;
    std::string name;
    int location = 1; ///< 1 nodes, 2 elements, 3 nodes on elements, 5 points.
    std::array<std::string, 5> lines;
    std::array<int, 6> kind {}; ///< Model, analysis, characteristic, result, data type (1 integer, 2, 4 real, 5, 6
                                ///< complex), values per location.
    std::array<UniversalLabel, 10> integers {};
    std::array<double, 12> reals {};
    std::vector<UniversalResult> results;
};

/** A set of any other number: its records as they stand. */
struct UnknownUniversalSet
{
    int number = 0;
    std::string records;
};

using UniversalSet = std::variant<UniversalFunction, UniversalShape, UniversalNodes, UniversalTrace, UniversalHeader,
                                  UniversalUnits, UniversalElements, UniversalResults, UnknownUniversalSet>;

/** The data sets of a universal file: 58 and 58b, 55, 15, 2411, 82, 151, 164, 2412 and 2414 as what they mean, others
   as they stand.

    Sets are read as instruments and programs write them, which is not always as the format says: counts that are wrong
   (what is there counts), numbers without blanks between them, exponents with D or without letter, half-full lines,
   units longer than their field, Latin-1 text (it becomes UTF-8).
    @param bytes   the whole file
    @param source  how errors name it
    @throws InputError  source, line, what is wrong
    [worker] Docs/FileFormats.md; SDRC universal data sets, https://www.ceas3.uc.edu/sdrluff. */
std::vector<UniversalSet> readUniversalFile (std::string_view bytes, const std::string& source);

/** Data sets as a universal file, in the columns of the format: six significant digits in single precision, 13 in
   double; binary functions as they are. What was read and written once is the same to the byte whenever it is read and
   written again. No dates are written: the same sets give the same bytes.
    @throws InputError  when a number is not finite
    [worker] */
std::string encodeUniversalFile (const std::vector<UniversalSet>&);

/** A data set of a universal file as bytes: what stands between its two lines of -1. */
struct UniversalSection
{
    int number = 0;                       ///< Its kind, for example 58.
    std::string_view records;             ///< Its text behind the line of the number, with all line ends.
    std::optional<std::string_view> data; ///< Of a 58b: the bytes behind the text.
    bool isBigEndian = false;             ///< Of a 58b.
    std::size_t firstLine = 0; ///< Number of the first record's line, from 1; lines behind binary data are not counted.
};

/** Cuts a file into its data sets. Text outside of sets is ignored. The end of binary data is where a line of -1
   begins: looked for where the numbers of the header say, with a line's end more or less, else from there on, because
   headers are often wrong.
    @param source  how errors name the file
    @throws InputError  when there is no set, one is not closed, or its number cannot be read
    [worker] */
std::vector<UniversalSection> universalSections (std::string_view file, const std::string& source);
} // namespace antinode
