using System.Diagnostics;

namespace NeuronMocap.Fuzz.Running;

/// <summary>
/// Removes everything from an input that its failure does not need: halves, quarters, down to single bytes, until nothing more can be removed.
/// </summary>
internal static class Minimizer
{
    private static readonly TimeSpan TimeLimit = TimeSpan.FromSeconds(10);

    public static byte[] Minimize(byte[] input, Func<byte[], bool> fails)
    {
        long start = Stopwatch.GetTimestamp();
        int before;
        do
        {
            before = input.Length;
            for (int size = Math.Max(1, input.Length / 2); size > 0; size /= 2)
                input = RemovePieces(input, size, fails, start);
        }
        while (input.Length < before && Stopwatch.GetElapsedTime(start) < TimeLimit);

        return input;
    }

    private static byte[] RemovePieces(byte[] input, int size, Func<byte[], bool> fails, long start)
    {
        int at = 0;
        while (at < input.Length && Stopwatch.GetElapsedTime(start) < TimeLimit)
        {
            byte[] shorter = [.. input.AsSpan(0, at), .. input.AsSpan(Math.Min(at + size, input.Length))];
            if (fails(shorter))
                input = shorter;
            else
                at += size;
        }

        return input;
    }
}
