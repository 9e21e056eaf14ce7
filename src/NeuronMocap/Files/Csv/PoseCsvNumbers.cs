namespace NeuronMocap.Csv;

// Writes whole numbers and times as digits, independently of the culture.
internal static class PoseCsvNumbers
{
    // Nineteen digits and a sign.
    private const int LongestWhole = 20;

    public static int WriteWhole(Span<byte> destination, long number)
    {
        Span<byte> reversed = stackalloc byte[LongestWhole];
        int count = 0;
        ulong rest = number < 0 ? 0 - (ulong)number : (ulong)number;
        do
        {
            reversed[count++] = (byte)('0' + (rest % 10));
            rest /= 10;
        }
        while (rest > 0);

        if (number < 0)
            reversed[count++] = (byte)'-';

        for (int i = 0; i < count; i++)
            destination[i] = reversed[count - 1 - i];

        return count;
    }

    // A tick is the seventh decimal of a second. Zeros at the end are left out.
    public static int WriteSeconds(Span<byte> destination, TimeSpan time)
    {
        int length = 0;
        if (time < TimeSpan.Zero)
            destination[length++] = (byte)'-';

        long seconds = Math.Abs(time.Ticks / TimeSpan.TicksPerSecond);
        long rest = Math.Abs(time.Ticks % TimeSpan.TicksPerSecond);
        length += WriteWhole(destination[length..], seconds);
        if (rest == 0)
            return length;

        destination[length++] = (byte)'.';
        for (long unit = TimeSpan.TicksPerSecond / 10; rest > 0; unit /= 10)
        {
            destination[length++] = (byte)('0' + (rest / unit));
            rest %= unit;
        }

        return length;
    }
}
