using NeuronMocap.Compatibility;

namespace NeuronMocap.Native.Host;

// What all exported functions share. Not in their own class, whose static constructor would run in front of their guards.
internal static class Library
{
    static Library()
    {
        Entry.SetHandlers();
        // Nobody asked for text in the program's standard error.
        CompatibilityEvents.CallbackFailed += static _ => { };
    }

    public static NativeCallbacks Callbacks { get; } = new();

    public static VendorFunctions Functions { get; } = new(Callbacks);
}
