using NeuronMocap.Compatibility;

namespace NeuronMocap.Native.Host;

// The objects that all exported functions share. They are in a separate class, because a static constructor of the exports would run outside their
// guards.
internal static class Library
{
    static Library()
    {
        Entry.SetHandlers();
        // The host program did not ask for text on its standard error stream.
        CompatibilityEvents.CallbackFailed += static _ => { };
    }

    public static NativeCallbacks Callbacks { get; } = new();

    public static VendorFunctions Functions { get; } = new(Callbacks);
}
