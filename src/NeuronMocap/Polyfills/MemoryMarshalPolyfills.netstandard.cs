using System.Runtime.InteropServices;

namespace NeuronMocap.Polyfills;

internal static class MemoryMarshalPolyfills
{
    extension(MemoryMarshal)
    {
        // .NET 8 takes the value by "in", .NET Standard by "ref".
        public static void Write<T>(Span<byte> destination, in T value)
            where T : struct
        {
            T copy = value;
            MemoryMarshal.Write(destination, ref copy);
        }
    }
}
