#pragma once

#include "ResultClass.h"
#include "Work.h"

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** Gives the members of a request what a call gave.
    @return  the argument `progress`
    @throws  InputError for values that are not allowed, TypeError for arguments that are unknown or missing
    [any] with the GIL */
pybind11::object assign (const std::vector<Field>&, const std::string& function, const pybind11::args&,
                         const pybind11::kwargs&);

/** A function of what is being done and its share, for as long as it lives: what `progress` stands for. [any] with the
    GIL */
class ShownProgress
{
public:
    explicit ShownProgress (const pybind11::object& progress);
    ~ShownProgress();
    ShownProgress (const ShownProgress&) = delete;
    ShownProgress& operator= (const ShownProgress&) = delete;

    pybind11::object show;

private:
    pybind11::object context;
};

/** Binds a task as a function: its keywords are the fields of its request. [any] with the GIL */
template <typename Request, typename Result>
void bindTask (pybind11::module_& module, const std::string& function, const TaskText& text, const std::string& result,
               Result (*task) (const Request&, const ShowProgress&))
{
    Request example;
    const auto documentation = documented (function, text, fields (example), result);
    pybind11::options options;
    options.disable_function_signatures();
    module.def (
        function.c_str(),
        [function, task] (const pybind11::args& arguments, const pybind11::kwargs& keywords)
        {
            Request request;
            const ShownProgress progress (assign (fields (request), function, arguments, keywords));
            Work work (progress.show);
            const auto show = work.progress();
            return work.run ([&] { return std::make_shared<Result> (task (request, show)); });
        },
        documentation.c_str());
}
} // namespace antinode
