#include "Module.h"

#include "ResultClass.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_tasks/Field.h>
#include <antinode_tracks/TrackDesign.h>

#include <exception>
#include <new>

namespace antinode
{
namespace
{
namespace py = pybind11;

py::object errorType (const char* name)
{
    return py::module_::import ("antinode.errors").attr (name);
}

void raise (const py::object& error)
{
    PyErr_SetObject (error.get_type().ptr(), error.ptr());
}

py::object limitError (const InputError& error, const py::dict& numbers)
{
    return errorType ("LimitError") (withKeysAndOptions (error.what()), **numbers);
}

void translate (std::exception_ptr exception)
{
    try
    {
        std::rethrow_exception (std::move (exception));
    }
    catch (const LimitError& error)
    {
        using namespace py::literals;
        raise (limitError (error, py::dict ("minimum_peak_voltage_V"_a = error.minimumPeakVoltage,
                                            "reachable_velocity_m_s"_a = error.reachableVelocity)));
    }
    catch (const TrackLimitError& error)
    {
        using namespace py::literals;
        raise (limitError (error, py::dict ("reachable_share"_a = error.share, "bound_share"_a = error.bound)));
    }
    catch (const InputError& error)
    {
        raise (errorType ("InputError") (withKeysAndOptions (error.what())));
    }
    catch (const Cancelled&)
    {
        PyErr_SetNone (PyExc_KeyboardInterrupt);
    }
    catch (const std::bad_alloc&)
    {
        PyErr_SetString (PyExc_MemoryError,
                         "not enough memory; choose a shorter duration, a lower sample rate or fewer modes");
    }
}
} // namespace

void registerErrors (py::module_&)
{
    py::register_exception_translator (&translate);
}
} // namespace antinode

PYBIND11_MODULE (_antinode, module)
{
    module.doc() = "The compiled part of the package antinode.";
    module.attr ("version") = ANTINODE_VERSION;
    antinode::registerErrors (module);
    antinode::bindDocuments (module);
    antinode::bindModes (module);
    antinode::bindDesign (module);
    antinode::bindPerform (module);
    antinode::bindMap (module);
    antinode::bindCompared (module);
    antinode::bindSweep (module);
    antinode::bindBench (module);
    antinode::bindLearning (module);
    module.def ("_stubs", &antinode::keptStubs);
}
