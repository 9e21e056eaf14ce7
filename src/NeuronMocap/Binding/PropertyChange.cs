using System.ComponentModel;
using System.Runtime.ExceptionServices;

namespace NeuronMocap;

// The arguments of the events are made once for each property, so an update without a change allocates nothing.
internal static class PropertyChange
{
    public static bool TrySet<T>(ref T field, T value)
    {
        if (EqualityComparer<T>.Default.Equals(field, value))
            return false;

        field = value;
        return true;
    }

    // An exception of a handler must not keep other changes back. failure: takes the first.
    public static void Raise(PropertyChangedEventHandler? handlers, object sender, PropertyChangedEventArgs changed, ref ExceptionDispatchInfo? failure)
    {
        try
        {
            handlers?.Invoke(sender, changed);
        }
        catch (Exception exception)
        {
            failure ??= ExceptionDispatchInfo.Capture(exception);
        }
    }
}
