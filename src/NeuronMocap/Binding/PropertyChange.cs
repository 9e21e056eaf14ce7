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
}
