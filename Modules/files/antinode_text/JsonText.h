#pragma once

#include <Eigen/Core>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace antinode
{
/** JSON from text: UTF-8, no duplicate keys, nesting at most 64 deep, all numbers finite.
    @param source  how errors name it
    @throws InputError  source, line and column or JSON pointer, what is wrong
    [worker] */
nlohmann::json parseJson (std::string_view text, const std::string& source);

/** JSON from a file of at most 64 MiB.
    @throws InputError  when it is missing, a directory, a pipe, unreadable, too large, or not JSON as
                        parseJson wants it
    [worker] */
nlohmann::json readJsonFile (const std::filesystem::path&);

/** JSON for people: an entry per line, lists without objects in one line. Ends with a line break. [any] */
std::string readableJson (const nlohmann::ordered_json&);

/** Sets one value, as `--set focus.targets.0.x_mm=24` gives it. A key that is a number indexes a list; the value is
   JSON where it parses as such, else a string. Missing objects on the way are made; a list grows by one at most.
    The size of a target or a track replaces one in another unit.
    @param root        the document
    @param assignment  "targets.0.x_mm=24"
    @throws InputError  when it has no '=', or a part does not fit the document
    [worker] */
void applyAssignment (nlohmann::json& root, std::string_view assignment);

/** A vector, or an expression of one, as a list of numbers. [any] */
template <typename Derived>
nlohmann::ordered_json toJsonList (const Eigen::MatrixBase<Derived>& values)
{
    auto list = nlohmann::ordered_json::array();

    for (Eigen::Index i = 0; i < values.size(); ++i)
        list.push_back (values.derived().coeff (i));

    return list;
}

/** A matrix as a list of its rows. [any] */
template <typename Derived>
nlohmann::ordered_json toJsonRows (const Eigen::MatrixBase<Derived>& values)
{
    auto rows = nlohmann::ordered_json::array();

    for (Eigen::Index i = 0; i < values.rows(); ++i)
        rows.push_back (toJsonList (values.row (i)));

    return rows;
}
} // namespace antinode
