#include "Amplifiers.h"

#include <algorithm>

namespace antinode
{
std::shared_ptr<const ModalModel> withAmplifiers (const std::shared_ptr<const ModalModel>& model,
                                                  const std::vector<double>& volts)
{
    if (std::all_of (volts.begin(), volts.end(), [] (double each) { return each == 0; }))
        return model;

    auto result = std::make_shared<ModalModel> (*model);

    for (std::size_t i = 0; i < std::min (volts.size(), result->ceramics.size()); ++i)
        result->ceramics[i].amplifierVoltage = volts[i];

    return result;
}
} // namespace antinode
