using System.Globalization;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace NeuronMocap.Polyfills;

// Members of number types that netstandard2.0 lacks.
internal static class NumberPolyfills
{
    extension(Math)
    {
        public static int Clamp(int value, int min, int max) => Math.Min(Math.Max(value, min), max);

        public static long Clamp(long value, long min, long max) => Math.Min(Math.Max(value, min), max);

        // NaN stays NaN.
        public static float Clamp(float value, float min, float max) => value < min ? min : value > max ? max : value;

        public static double Clamp(double value, double min, double max) => value < min ? min : value > max ? max : value;
    }

    extension(float)
    {
        public static bool IsFinite(float value) => (BitConverter.SingleToInt32Bits(value) & int.MaxValue) < 0x7F80_0000;

        public static bool IsNegative(float value) => BitConverter.SingleToInt32Bits(value) < 0;
    }

    extension(double)
    {
        public static bool IsFinite(double value) => (BitConverter.DoubleToInt64Bits(value) & long.MaxValue) < 0x7FF0_0000_0000_0000;
    }

    extension(int)
    {
        public static bool TryParse(ReadOnlySpan<char> text, NumberStyles style, IFormatProvider? provider, out int result) =>
            int.TryParse(text.ToString(), style, provider, out result);
    }

    extension(ushort)
    {
        public static bool TryParse(ReadOnlySpan<char> text, NumberStyles style, IFormatProvider? provider, out ushort result) =>
            ushort.TryParse(text.ToString(), style, provider, out result);
    }

    extension(BitConverter)
    {
        public static int SingleToInt32Bits(float value) => Unsafe.As<float, int>(ref value);

        public static float Int32BitsToSingle(int value) => Unsafe.As<int, float>(ref value);

        public static bool TryWriteBytes(Span<byte> destination, uint value) =>
            MemoryMarshal.TryWrite(destination, ref value);
    }
}
