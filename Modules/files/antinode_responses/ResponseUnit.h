#pragma once

#include <antinode_identification/FrequencyResponses.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace antinode
{
/** The measured quantity of a point's motion. */
enum class ResponseQuantity
{
    displacement,
    velocity,
    acceleration
};

/** The meaning of a response's numbers, as far as known. */
struct ResponseUnit
{
    std::optional<ResponseQuantity> quantity;
    double factor = 1; ///< SI units of motion and drive that a number of 1 stands for: m, m/s or m/s^2, per V or N
                       ///< where the drive is known.
    std::optional<DriveQuantity> drive;
};

/** A unit as physicalUnit knows them: "(m/s^2)/N", "mm/s/V", "g's/lbf", "(1/N)*(m/s²)", "um V^-1", "1/kg", also of a
   motion alone, and "(m/s^2)(N)" for the ratio of the two. g is the acceleration of gravity. Empty if the text is no
   unit of a motion, or of a motion per volt or newton. [any] */
std::optional<ResponseUnit> responseUnit (std::string_view text);

/** The factor of a unit of drive alone, "N" or "mV". Empty if it is none. [any] */
std::optional<ResponseUnit> driveUnit (std::string_view text);

/** Whether a label that stands for a unit is neither of these nor says that there is none ("NONE", "ratio", "EU").
 * [any]
 */
bool isUnknownUnit (std::string_view label);

/** The remark that a label is no known unit. @param source  the file [any] */
std::string unknownUnitRemark (const std::string& source, const std::string& label);

/** The meaning of a word for a response: accelerance, mobility, velocity, receptance, ...; empty if it has none. [any]
 */
std::optional<ResponseUnit> quantityWord (std::string_view word);

/** A product of powers of units: its size in SI units and the exponents of metre, second, newton and volt. */
struct PhysicalUnit
{
    double factor = 1;
    std::array<int, 4> exponents {};
};

/** A unit as people and programs write it, with products, quotients, powers and brackets; a number may begin it. Metric
   prefixes, names in full, plurals and capitals are known, and the units of vibration in inches, pounds and multiples
   of gravity: "m/s^2", "in/sec^2", "g's", "mg", "Gal", "ips", "lbf", "kgf", "(m/s^2)/N", "um V^-1". Empty where a part
   of it is no unit of length, time, force or voltage. [any] */
std::optional<PhysicalUnit> physicalUnit (std::string_view text);
} // namespace antinode
