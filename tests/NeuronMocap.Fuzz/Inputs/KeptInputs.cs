namespace NeuronMocap.Fuzz.Inputs;

/// <summary>
/// Inputs that once revealed a fault: small files of the folder <c>corpus</c>, named after their target and fault. They are part of the program.
/// </summary>
internal static class KeptInputs
{
    private const string Prefix = "corpus/";

    /// <summary>All inputs with their file names, in a fixed order.</summary>
    public static IReadOnlyList<(string Name, byte[] Bytes)> All { get; } =
    [
        .. typeof(KeptInputs).Assembly.GetManifestResourceNames()
            .Where(static name => name.StartsWith(Prefix, StringComparison.Ordinal))
            .Order(StringComparer.Ordinal)
            .Select(static name => (name[Prefix.Length..], Read(name))),
    ];

    private static byte[] Read(string name)
    {
        using Stream stream = typeof(KeptInputs).Assembly.GetManifestResourceStream(name)!;
        byte[] bytes = new byte[stream.Length];
        stream.ReadExactly(bytes);
        return bytes;
    }
}
