#include "Keywords.h"

#include "Arrays.h"
#include "Values.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/ExcitationFile.h>
#include <antinode_tasks/Design.h>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

namespace antinode
{
namespace
{
namespace py = pybind11;

/** @throws InputError  naming the keyword */
template <typename Given>
void check (const Field& field, const Given& given)
{
    if (const auto refusal = refusalOf (field, given); ! refusal.empty())
        throw InputError (field.keyword, refusal);
}

py::type_error wrongType (const Field& field, const py::handle& given)
{
    return py::type_error (field.keyword + ": is of type "
                           + py::type::handle_of (given).attr ("__name__").cast<std::string>());
}

/** @throws TypeError  naming the keyword */
template <typename Wanted>
Wanted cast (const Field& field, const py::handle& given)
{
    try
    {
        return given.cast<Wanted>();
    }
    catch (const py::cast_error&)
    {
        throw wrongType (field, given);
    }
}

/** What an iterable gives, which no text is. @throws TypeError  naming the keyword */
py::list listOf (const Field& field, const py::handle& given)
{
    if (py::isinstance<py::str> (given) || py::isinstance<py::bytes> (given) || ! py::hasattr (given, "__iter__"))
        throw wrongType (field, given);

    return py::list (py::reinterpret_borrow<py::object> (given));
}

py::object documents (const char* function)
{
    return py::module_::import ("antinode._documents").attr (function);
}

/** The numbers of a row that is given as a number or as a sequence. */
std::vector<double> rowOf (const Field& field, const NumberRows& rows, const py::handle& given)
{
    std::vector<double> numbers;

    try
    {
        const auto add = [&] (const py::handle& number)
        {
            if (py::isinstance<py::str> (number)) // Which Python would read as a number.
                throw wrongType (field, number);

            numbers.push_back (py::float_ (py::reinterpret_borrow<py::object> (number)));
        };

        if (py::hasattr (given, "__len__") && ! py::isinstance<py::str> (given))
            for (const auto& each : given)
                add (each);
        else
            add (given);
    }
    catch (const py::error_already_set&)
    {
        numbers.clear();
    }
    catch (const py::type_error&)
    {
        numbers.clear();
    }

    if (numbers.size() < rows.least || numbers.size() > rows.most)
        throw InputError (field.keyword,
                          py::repr (given).cast<std::string>() + " is not allowed; allowed: " + rows.allowed);

    return numbers;
}

/** x and y of places that are given as x, or as x and y, mm. */
Eigen::MatrixX2d placesOf (const Field& field, const py::handle& given)
{
    std::vector<std::vector<double>> rows;

    for (const auto& each : listOf (field, given))
        rows.push_back (rowOf (field, { "x, or x and y, mm", 1, 2, true, {} }, each));

    Eigen::MatrixX2d places = Eigen::MatrixX2d::Zero (static_cast<Eigen::Index> (rows.size()), 2);

    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t axis = 0; axis < rows[i].size(); ++axis)
            places (static_cast<Eigen::Index> (i), static_cast<Eigen::Index> (axis)) = rows[i][axis] / milli;

    if (! places.allFinite() || (field.isRequired && places.rows() == 0))
        throw InputError (field.keyword, "are none or not finite; allowed: at least one place on the surface, mm");

    return places;
}

/** Plays by a function of Python. The request, which outlives the work, has the last hold of it: no thread without the
    GIL lets it go. */
PlayFunction playerOf (const py::object& function)
{
    return [play = std::make_shared<py::object> (function)] (const Eigen::MatrixXd& voltages, int pass)
    {
        const py::gil_scoped_acquire withGil;
        return matrixOf ((*play) (arrayOf (Eigen::MatrixXd (voltages)), pass), "play");
    };
}

/** Keeps what one field is given. */
class Assigner
{
public:
    Assigner (const Field& assigned, py::object value, py::object& named)
        : field (assigned), given (std::move (value)), reader (named)
    {
    }

    void operator() (bool* value) const { *value = cast<bool> (field, given); }
    void operator() (int* value) const { *value = number<int> (*value); }
    void operator() (std::uint64_t* value) const { *value = number<std::uint64_t>(); }
    void operator() (double* value) const { *value = number<double> (*value * field.perUnit) / field.perUnit; }

    void operator() (std::optional<int>* value) const
    {
        if (isGiven())
            *value = number<int>();
    }

    void operator() (std::optional<double>* value) const
    {
        if (isGiven())
            *value = number<double>() / field.perUnit;
    }

    void operator() (std::string* value) const { *value = word(); }

    void operator() (std::optional<std::string>* value) const
    {
        if (isGiven() && ! given.equal (py::str()))
            *value = word();
    }

    void operator() (std::filesystem::path* value) const
    {
        if (isGiven())
            *value = cast<std::filesystem::path> (field, given);
    }

    void operator() (std::vector<std::string>* value) const
    {
        *value = cast<std::vector<std::string>> (field, listOf (field, given));
    }

    void operator() (std::vector<std::filesystem::path>* value) const
    {
        *value = cast<std::vector<std::filesystem::path>> (field, listOf (field, given));
    }

    void operator() (std::vector<double>* value) const { list (value); }
    void operator() (std::vector<int>* value) const { list (value); }

    void operator() (const NumberRows& rows) const
    {
        if (! rows.repeats)
        {
            if (isGiven())
                rows.take (rowOf (field, rows, given));

            return;
        }

        for (const auto& each : listOf (field, given))
            rows.take (rowOf (field, rows, each));
    }

    void operator() (const WordFlag&) const {}
    void operator() (const TextRows&) const {}

    void operator() (const FocusOrDesign& value) const
    {
        if (py::isinstance<DesignedFocus> (given))
            *value.design = given.cast<std::shared_ptr<DesignedFocus>>();
        else
            (*this) (value.focus);
    }

    void operator() (const FocusSeries& value) const { (*this) (value.focus); }
    void operator() (Eigen::MatrixX2d* value) const { *value = placesOf (field, given); }

    void operator() (std::optional<Eigen::MatrixXd>* value) const
    {
        if (isGiven())
            *value = matrixOf (given, field.keyword);
    }

    void operator() (PlayFunction* value) const
    {
        if (isGiven())
            *value = playerOf (given);
    }

    void operator() (DeviceDescription* value) const
    {
        // A design has its own.
        const auto isOfDesign = ! field.otherwise.empty() && given.is_none() && reader.is_none();
        const auto source = isOfDesign ? py::object (py::str (field.usual)) : given;
        const auto device = reader.is_none() ? documents ("device_of") (source)
                                             : documents ("device_for") (reader, source, field.usual);
        *value = device.attr ("_core").cast<const DeviceValue&>().description;
    }

    void operator() (std::vector<DeviceDescription>* value) const
    {
        for (const auto& each : listOf (field, given))
            value->push_back (documents ("device_of") (each).attr ("_core").cast<const DeviceValue&>().description);
    }

    void operator() (const OptionalDevice& value) const
    {
        if (isGiven())
            *value.device = documents ("device_of") (given).attr ("_core").cast<const DeviceValue&>().description;
    }

    void operator() (FocusDescription* value) const
    {
        reader = documents ("focus_of") (given);
        *value = reader.attr ("_core").cast<const FocusValue&>().description;
    }

    void operator() (std::vector<FocusDescription>* value) const
    {
        for (const auto& each : listOf (field, given))
            value->push_back (documents ("focus_of") (each).attr ("_core").cast<const FocusValue&>().description);
    }

    void operator() (WaveformsDescription* value) const
    {
        reader = documents ("waveforms_of") (given);
        *value = reader.attr ("_core").cast<const WaveformsValue&>().description;
    }

    void operator() (const OptionalWaveforms& value) const
    {
        if (isGiven())
            *value.waveforms =
                documents ("waveforms_of") (given).attr ("_core").cast<const WaveformsValue&>().description;
    }

    void operator() (const OptionalSheet& value) const
    {
        if (isGiven())
            *value.sheet = py::isinstance<ExcitationSheet> (given)
                               ? given.cast<const ExcitationSheet&>()
                               : readSheet (cast<std::filesystem::path> (field, given));
    }

private:
    bool isGiven() const { return ! given.is_none(); }

    /** A number within its range; what is there already, the default, may lie beyond it. */
    template <typename Number>
    Number number (std::optional<double> usual = {}) const
    {
        const auto wide = wideNumber<Number> (given);

        if (wide != usual)
            check (field, wide);

        return narrowed<Number> (given, wide);
    }

    template <typename Number>
    double wideNumber (const py::handle& value) const
    {
        if (std::is_integral_v<Number> && ! py::hasattr (value, "__index__"))
            throw wrongType (field, value);

        return cast<double> (field, value);
    }

    template <typename Number>
    Number narrowed (const py::handle& value, double wide) const
    {
        if constexpr (std::is_floating_point_v<Number>)
            return wide;
        else
            try
            {
                return value.cast<Number>();
            }
            catch (const py::cast_error&)
            {
                throw InputError (field.keyword,
                                  "is " + fieldNumber (wide) + "; allowed: whole numbers that are less large");
            }
    }

    template <typename Number>
    void list (std::vector<Number>* value) const
    {
        value->clear();

        for (const auto& each : listOf (field, given))
        {
            const auto wide = wideNumber<Number> (each);
            check (field, wide);
            value->push_back (narrowed<Number> (each, wide));
        }
    }

    std::string word() const
    {
        auto text = cast<std::string> (field, given);
        check (field, text);
        return text;
    }

    const Field& field;
    py::object given;
    py::object& reader; ///< The focus or the waveforms, which may name a device.
};

/** The fields of arguments without names, in their order; those after them go to a list of files. */
struct Positions
{
    std::vector<const Field*> single;
    const Field* variadic = nullptr;
};

Positions positionsOf (const std::vector<Field>& fields)
{
    Positions positions;

    for (const auto& field : fields)
        if (field.isPositional && ! field.keyword.empty())
        {
            if (std::holds_alternative<std::vector<std::filesystem::path>*> (field.value))
                positions.variadic = &field;
            else
                positions.single.push_back (&field);
        }

    return positions;
}

/** All arguments by their keywords. @throws TypeError  for too many, and for one that is given twice */
py::dict named (const std::vector<Field>& fields, const std::string& function, const py::args& arguments,
                const py::kwargs& keywords)
{
    const auto positions = positionsOf (fields);
    const auto singles = std::min (positions.single.size(), arguments.size());
    py::dict given;

    for (std::size_t i = 0; i < singles; ++i)
        given[positions.single[i]->keyword.c_str()] = arguments[i];

    if (positions.variadic != nullptr)
        given[positions.variadic->keyword.c_str()] =
            arguments[py::slice (static_cast<py::ssize_t> (singles), PY_SSIZE_T_MAX, 1)];
    else if (arguments.size() > singles)
        throw py::type_error (function + "() takes " + std::to_string (positions.single.size())
                              + " positional arguments but " + std::to_string (arguments.size()) + " were given");

    for (const auto& [key, value] : keywords)
    {
        if (given.contains (key))
            throw py::type_error (function + "() got multiple values for argument '" + key.cast<std::string>() + "'");

        given[key] = value;
    }

    return given;
}

bool mayNameDevice (const Field& field)
{
    return std::holds_alternative<FocusDescription*> (field.value)
           || std::holds_alternative<FocusOrDesign> (field.value)
           || std::holds_alternative<WaveformsDescription*> (field.value);
}

void requireFiles (const Field& field, const py::handle& given)
{
    if (field.isRequired && py::len (given) == 0)
        throw InputError (field.keyword, "are none; allowed: at least one file");
}
} // namespace

py::object assign (const std::vector<Field>& fields, const std::string& function, const py::args& arguments,
                   const py::kwargs& keywords)
{
    auto given = named (fields, function, arguments, keywords);
    py::object reader = py::none(), progress = py::none();
    auto ordered = fields; // Focuses and waveforms first: they may name the device.
    std::stable_partition (ordered.begin(), ordered.end(), mayNameDevice);

    for (const auto& field : ordered)
    {
        if (field.keyword.empty())
            continue;

        const auto isGiven = given.contains (field.keyword);
        const auto isDocument = ! field.usual.empty();

        if (! isGiven && field.isRequired)
            throw py::type_error (function + "() missing 1 required argument: '" + field.keyword + "'");

        if (! isGiven && ! isDocument)
            continue;

        py::object value = isGiven                     ? py::object (given[field.keyword.c_str()])
                           : ! field.otherwise.empty() ? py::object (py::none())
                                                       : py::object (py::str (field.usual));

        if (std::holds_alternative<std::vector<std::filesystem::path>*> (field.value))
            requireFiles (field, value);

        std::visit (Assigner (field, value, reader), field.value);

        if (isGiven)
            given.attr ("pop") (field.keyword);
    }

    if (given.contains ("progress"))
        progress = given.attr ("pop") ("progress");

    if (! given.empty())
        throw py::type_error (function + "() got an unexpected keyword argument "
                              + py::repr (*given.attr ("__iter__")().attr ("__next__")()).cast<std::string>());

    return progress;
}

ShownProgress::ShownProgress (const py::object& progress)
    : context (py::module_::import ("antinode._progress").attr ("shown") (progress))
{
    show = context.attr ("__enter__")();
}

ShownProgress::~ShownProgress()
{
    try
    {
        context.attr ("__exit__") (py::none(), py::none(), py::none());
    }
    catch (py::error_already_set& error)
    {
        error.discard_as_unraisable ("progress");
    }
}
} // namespace antinode
