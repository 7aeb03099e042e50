#include "RawVst3.h"

#include "Support/Environment.h"
#include "Support/LoadedLibrary.h"

#include <cstdlib>
#include <stdexcept>

namespace antinode::test
{
namespace
{
template <typename Function>
Function findSymbol (void* module, const char* name)
{
    return reinterpret_cast<Function> (symbolOf (module, name));
}

/** What a host calls first; each system has its own name for it. */
void enterModule (void* module)
{
#ifdef _WIN32
    findSymbol<bool (*)()> (module, "InitDll")();
#else
    findSymbol<bool (*) (void*)> (module, "ModuleEntry") (module);
#endif
}

template <typename Interface>
Interface* queried (Steinberg::FUnknown* object)
{
    void* found = nullptr;

    if (object->queryInterface (Interface::iid, &found) != Steinberg::kResultOk)
        throw std::runtime_error ("an interface is missing");

    return static_cast<Interface*> (found);
}

template <typename Interface>
Interface* created (const Steinberg::TUID classIdentifier)
{
    void* made = nullptr;

    if (vst3Factory().createInstance (classIdentifier, Interface::iid, &made) != Steinberg::kResultOk)
        throw std::runtime_error ("the factory makes no instance");

    return static_cast<Interface*> (made);
}

/** The factory's class of a category. */
Steinberg::PClassInfo findClass (const std::string& category)
{
    Steinberg::PClassInfo info;

    for (int i = 0; i < vst3Factory().countClasses(); ++i)
        if (vst3Factory().getClassInfo (i, &info) == Steinberg::kResultOk && info.category == category)
            return info;

    throw std::runtime_error ("the factory has no " + category);
}

Vst::SpeakerArrangement lowestSpeakers (int count)
{
    return count >= 64 ? ~0ULL : (1ULL << count) - 1;
}
} // namespace

Steinberg::IPluginFactory& vst3Factory()
{
    static auto& factory = []() -> Steinberg::IPluginFactory&
    {
        auto* const module = loadLibrary (ANTINODE_VST3_BINARY);
        enterModule (module);
        return *findSymbol<Steinberg::IPluginFactory*(PLUGIN_API*) ()> (module, "GetPluginFactory")();
    }();
    return factory;
}

RawVst3::RawVst3 (int ceramics, Connection connection)
{
    setVariable ("ANTINODE_CERAMICS", std::to_string (ceramics));
    component = created<Vst::IComponent> (findClass (kVstAudioEffectClass).cid);
    removeVariable ("ANTINODE_CERAMICS");
    component->initialize (&application);
    processor = queried<Vst::IAudioProcessor> (component);
    Steinberg::TUID controllerIdentifier;
    component->getControllerClassId (controllerIdentifier);
    controller = created<Vst::IEditController> (controllerIdentifier);
    controller->initialize (&application);
    controller->setComponentHandler (&handler);
    connect (connection);
    Steinberg::MemoryStream stream;
    component->getState (&stream);
    stream.seek (0, Steinberg::IBStream::kIBSeekSet, nullptr);
    controller->setComponentState (&stream);

    for (int bus = 0; bus < 2; ++bus)
        component->activateBus (Vst::kAudio, Vst::kOutput, bus, true);

    component->activateBus (Vst::kEvent, Vst::kInput, 0, true);
}

void RawVst3::connect (Connection connection)
{
    componentEnd = queried<Vst::IConnectionPoint> (component);
    controllerEnd = queried<Vst::IConnectionPoint> (controller);

    if (connection == Connection::byMessages)
    {
        toComponent = std::make_unique<ConnectionProxy> (componentEnd);
        toController = std::make_unique<ConnectionProxy> (controllerEnd);
    }

    Vst::IConnectionPoint* const seenByComponent = toController != nullptr ? toController.get() : controllerEnd;
    Vst::IConnectionPoint* const seenByController = toComponent != nullptr ? toComponent.get() : componentEnd;
    componentEnd->connect (seenByComponent);
    controllerEnd->connect (seenByController);
}

RawVst3::~RawVst3()
{
    Vst::IConnectionPoint* const seenByComponent = toController != nullptr ? toController.get() : controllerEnd;
    Vst::IConnectionPoint* const seenByController = toComponent != nullptr ? toComponent.get() : componentEnd;
    deactivate();
    controllerEnd->disconnect (seenByController);
    componentEnd->disconnect (seenByComponent);
    controller->setComponentHandler (nullptr);
    controllerEnd->release();
    componentEnd->release();
    controller->terminate();
    component->terminate();
    controller->release();
    processor->release();
    component->release();
}

Steinberg::tresult RawVst3::arrange (Vst::SpeakerArrangement main, Vst::SpeakerArrangement monitor)
{
    Vst::SpeakerArrangement sensor = Vst::SpeakerArr::kMono, outputs[] = { main, monitor };
    return processor->setBusArrangements (&sensor, 1, outputs, 2);
}

bool RawVst3::setLayout (int ceramics, int monitors)
{
    Vst::SpeakerArrangement wanted[] = { lowestSpeakers (ceramics),
                                         monitors == 1 ? Vst::SpeakerArr::kMono : Vst::SpeakerArr::kStereo };
    const auto isSet = arrange (wanted[0], wanted[1]) == Steinberg::kResultTrue;
    active[1] = monitors > 0;
    component->activateBus (Vst::kAudio, Vst::kOutput, 0, true);
    component->activateBus (Vst::kAudio, Vst::kOutput, 1, active[1]);
    return isSet && channels (0) == ceramics && (! active[1] || channels (1) == monitors);
}

int RawVst3::channels (int bus) const
{
    Vst::BusInfo info {};
    component->getBusInfo (Vst::kAudio, Vst::kOutput, bus, info);
    return info.channelCount;
}

void RawVst3::activate (const Processing& wanted)
{
    processing = wanted;
    Vst::ProcessSetup setup { wanted.isOffline ? Vst::kOffline : Vst::kRealtime,
                              wanted.isDouble ? Vst::kSample64 : Vst::kSample32, wanted.longestBlock,
                              wanted.sampleRate };
    processor->setupProcessing (setup);
    component->setActive (true);
    processor->setProcessing (true);
}

void RawVst3::deactivate()
{
    processor->setProcessing (false);
    component->setActive (false);
}

std::vector<Vst::ParameterInfo> RawVst3::parameters()
{
    std::vector<Vst::ParameterInfo> all (static_cast<std::size_t> (controller->getParameterCount()));

    for (std::size_t i = 0; i < all.size(); ++i)
        if (controller->getParameterInfo (static_cast<Steinberg::int32> (i), all[i]) != Steinberg::kResultTrue)
            throw std::runtime_error ("a parameter has no description");

    return all;
}

Vst::ParamID RawVst3::parameter (const std::u16string& title)
{
    for (const auto& info : parameters())
        if (reinterpret_cast<const char16_t*> (info.title) == title)
            return info.id;

    throw std::runtime_error ("there is no such parameter");
}

std::string RawVst3::state()
{
    Steinberg::MemoryStream stream;
    component->getState (&stream);
    return { stream.getData(), static_cast<std::size_t> (stream.getSize()) };
}

bool RawVst3::setState (const std::string& text)
{
    Steinberg::MemoryStream stream (const_cast<char*> (text.data()), static_cast<Steinberg::TSize> (text.size()));
    return component->setState (&stream) == Steinberg::kResultTrue;
}
} // namespace antinode::test
