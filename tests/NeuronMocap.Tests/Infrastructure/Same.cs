namespace NeuronMocap.Tests.Infrastructure;

/// <summary>Asserts that long sequences are equal. xunit compares them element by element with reflection, so it only describes a difference here.</summary>
internal static class Same
{
    public static void Items<T>(IEnumerable<T> expected, IEnumerable<T> actual)
        where T : IEquatable<T>
    {
        T[] wanted = [.. expected];
        T[] found = [.. actual];
        if (!wanted.AsSpan().SequenceEqual(found))
            Assert.Equal(wanted, found);
    }

    public static void Packets(IEnumerable<byte[]> expected, IEnumerable<byte[]> actual)
    {
        byte[][] wanted = [.. expected];
        byte[][] found = [.. actual];
        bool areEqual = wanted.Length == found.Length;
        for (int i = 0; areEqual && i < wanted.Length; i++)
            areEqual = wanted[i].AsSpan().SequenceEqual(found[i]);

        if (!areEqual)
            Assert.Equal(wanted, found);
    }
}
