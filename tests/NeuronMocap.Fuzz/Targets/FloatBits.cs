namespace NeuronMocap.Fuzz.Targets;

/// <summary>Compares values bit for bit, except that NaN has many bit patterns but only one text.</summary>
internal static class FloatBits
{
    public static bool AreSame(ReadOnlySpan<float> first, ReadOnlySpan<float> second)
    {
        if (first.Length != second.Length)
            return false;

        for (int i = 0; i < first.Length; i++)
        {
            if (BitConverter.SingleToInt32Bits(first[i]) != BitConverter.SingleToInt32Bits(second[i]) && !(float.IsNaN(first[i]) && float.IsNaN(second[i])))
                return false;
        }

        return true;
    }

    /// <summary>Returns a sum that distinguishes rows in a digest.</summary>
    public static int Sum(ReadOnlySpan<float> values)
    {
        int sum = 0;
        foreach (float value in values)
            sum = (sum * 31) + (float.IsNaN(value) ? 1 : BitConverter.SingleToInt32Bits(value));

        return sum;
    }
}
