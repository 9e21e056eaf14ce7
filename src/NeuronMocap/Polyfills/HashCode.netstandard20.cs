namespace NeuronMocap.Polyfills;

internal static class HashCode
{
    private const uint Prime1 = 2_654_435_761;
    private const uint Prime2 = 2_246_822_519;

    public static int Combine<T1, T2, T3, T4>(T1 value1, T2 value2, T3 value3, T4 value4)
    {
        uint hash = Add(Add(Add(Add(Prime1, value1), value2), value3), value4);
        hash ^= hash >> 15;
        hash *= Prime2;
        return (int)(hash ^ (hash >> 13));
    }

    private static uint Add<T>(uint hash, T value)
    {
        hash += (uint)(value?.GetHashCode() ?? 0) * Prime2;
        return ((hash << 13) | (hash >> 19)) * Prime1;
    }
}
