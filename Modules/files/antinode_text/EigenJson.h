#pragma once

#include <Eigen/Core>

#include <nlohmann/json.hpp>

namespace antinode
{
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
