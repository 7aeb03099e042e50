#pragma once

#include <Eigen/Core>
#include <antinode_base/InputError.h>
#include <antinode_base/Reflection.h>
#include <antinode_model/ModalModel.h>
#include <antinode_outline/Outline.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace antinode
{
static_assert (std::endian::native == std::endian::little, "numbers are streamed as they lie in memory");

/** Appends values to bytes, little-endian: numbers raw, lengths before what has some,
    structs by their `fields` function. */
class FieldWriter
{
public:
    /** [worker] */
    template <typename... Fields>
    void operator() (const Fields&... values)
    {
        (write (values), ...);
    }

    std::string bytes;

private:
    void raw (const void* data, std::size_t size) { bytes.append (static_cast<const char*> (data), size); }
    void writeSize (std::uint64_t size) { raw (&size, sizeof (size)); }

    template <typename Number>
    requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
    void write (const Number& number) { raw (&number, sizeof (number)); }

    void write (const std::string& text)
    {
        writeSize (text.size());
        raw (text.data(), text.size());
    }

    template <typename Number, int rows, int columns>
    void write (const Eigen::Matrix<Number, rows, columns>& matrix)
    {
        writeSize (static_cast<std::uint64_t> (matrix.rows()));
        writeSize (static_cast<std::uint64_t> (matrix.cols()));
        raw (matrix.data(), static_cast<std::size_t> (matrix.size()) * sizeof (Number));
    }

    template <typename Value>
    void write (const std::vector<Value>& values)
    {
        writeSize (values.size());

        for (const auto& value : values)
            write (value);
    }

    template <typename Value>
    void write (const std::optional<Value>& value)
    {
        write (value.has_value());

        if (value)
            write (*value);
    }

    template <typename Value>
    requires std::is_class_v<Value>
    void write (const Value& value) { fields (*this, value); }
};

/** Reads what FieldWriter wrote, from untrusted bytes: nothing is allocated beyond their content. */
class FieldReader
{
public:
    explicit FieldReader (std::string_view bytesToRead) : rest (bytesToRead) {}

    /** @throws InputError  when the bytes end too early, or a number is not finite or not of its kind [worker] */
    template <typename... Fields>
    void operator() (Fields&... values)
    {
        (read (values), ...);
    }

    bool isAtEnd() const { return rest.empty(); }

private:
    static void require (bool fulfilled)
    {
        if (! fulfilled)
            throw InputError ("stored data", "are damaged");
    }

    void raw (void* data, std::size_t size)
    {
        require (size <= rest.size());

        if (size > 0) // An empty matrix has no address to copy to.
            std::memcpy (data, rest.data(), size);

        rest.remove_prefix (size);
    }

    template <typename Number>
    requires std::is_arithmetic_v<Number>
    void read (Number& number)
    {
        raw (&number, sizeof (number));

        if constexpr (std::is_floating_point_v<Number>)
            require (std::isfinite (number));
    }

    void read (bool& value)
    {
        std::uint8_t byte = 0;
        read (byte);
        require (byte <= 1);
        value = byte == 1;
    }

    void read (std::string& text)
    {
        std::uint64_t size = 0;
        read (size);
        require (size <= rest.size());
        text = rest.substr (0, size);
        rest.remove_prefix (size);
    }

    template <typename Number, int rowsWanted, int columnsWanted>
    void read (Eigen::Matrix<Number, rowsWanted, columnsWanted>& matrix)
    {
        constexpr std::uint64_t maximum = std::uint64_t (1) << 31; // The product of two of them fits into 64 bits.
        std::uint64_t rows = 0, columns = 0;
        read (rows);
        read (columns);
        require (rows < maximum && columns < maximum && rows * columns <= rest.size() / sizeof (Number));
        require (columnsWanted == Eigen::Dynamic || columns == static_cast<std::uint64_t> (columnsWanted));
        matrix.resize (static_cast<Eigen::Index> (rows), static_cast<Eigen::Index> (columns));
        raw (matrix.data(), rows * columns * sizeof (Number));

        if constexpr (std::is_floating_point_v<Number>)
            require (matrix.allFinite());
    }

    template <typename Value>
    void read (std::vector<Value>& values)
    {
        std::uint64_t size = 0;
        read (size);
        values.clear();

        while (values.size() < size) // Grows with what is there, not with what is claimed.
            read (values.emplace_back());
    }

    template <typename Value>
    void read (std::optional<Value>& value)
    {
        bool hasValue = false;
        read (hasValue);

        if (hasValue)
            read (value ? *value : value.emplace());
        else
            value.reset();
    }

    template <typename Value>
    requires std::is_class_v<Value>
    void read (Value& value) { fields (*this, value); }

    std::string_view rest;
};

/** All fields of a modal model, in the order of their declaration, to be written or read. A field that is missing here
   does not compile. @throws InputError  as FieldReader [worker] */
void fields (auto& stream, Struct<InputLag> auto& lag)
{
    auto& [delay, timeConstant, angle] = lag;
    stream (delay, timeConstant, angle);
}

void fields (auto& stream, Struct<Ceramic> auto& ceramic)
{
    auto& [name, xMinimum, xMaximum, yMinimum, yMaximum, voltageLimit, slewLimit, capacitance, lossFactor, area,
           currentLimit, amplifierVoltage, lag, outline] = ceramic;
    stream (name, xMinimum, xMaximum, yMinimum, yMaximum, voltageLimit, slewLimit, capacitance, lossFactor, area,
            currentLimit, amplifierVoltage, lag, outline);
}

void fields (auto& stream, Struct<GridAxis> auto& axis)
{
    auto& [places, weights, edges, first] = axis;
    stream (places, weights, edges, first);
}

void fields (auto& stream, Struct<PlateGrid> auto& grid)
{
    auto& [x, y] = grid;
    stream (x, y);
}

void fields (auto& stream, Struct<HeldEdges> auto& held)
{
    auto& [left, right, bottom, top] = held;
    stream (left, right, bottom, top);
}

void fields (auto& stream, Struct<SurfaceBoundary> auto& boundary)
{
    auto& [outline, held] = boundary;
    stream (outline, held);
}

void fields (auto& stream, Struct<Surface> auto& surface)
{
    auto& [kind, xMinimum, xMaximum, yMinimum, yMaximum, points, masses, areas, grid, held, boundary] = surface;
    auto isPlate = kind == SurfaceKind::plate;
    stream (isPlate, xMinimum, xMaximum, yMinimum, yMaximum, points, masses, areas, grid, held, boundary);

    if constexpr (! std::is_const_v<std::remove_reference_t<decltype (surface)>>)
        kind = isPlate ? SurfaceKind::plate : SurfaceKind::line;
}

void fields (auto& stream, Struct<ModalModel> auto& model)
{
    auto& [name, surface, angularFrequencies, dampingRatios, shapes, slopes, participation, staticShare, ceramics,
           fullScaleVoltage, coversWholeBody, rigidBodyModes, unknowns, frequencyErrors, warnings, origin] = model;
    stream (name, surface, angularFrequencies, dampingRatios, shapes, slopes, participation, ceramics, fullScaleVoltage,
            coversWholeBody, rigidBodyModes, unknowns, frequencyErrors, warnings);

    // Only what is drawn is solved, and cached.
    if constexpr (! std::is_const_v<std::remove_reference_t<decltype (model)>>)
    {
        staticShare.resize (0, 0);
        origin = { ModeSource::drawn };
    }
}
} // namespace antinode
