namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Fixtures to create inputs from, and words with a meaning for the parser.</summary>
/// <param name="Fixtures">Valid inputs, with the program's own first.</param>
/// <param name="OwnCount">The number of the program's own fixtures.</param>
/// <param name="Words">Tokens, keywords, and numbers at limits.</param>
internal sealed record Corpus(IReadOnlyList<byte[]> Fixtures, int OwnCount, IReadOnlyList<byte[]> Words)
{
    // The start of a long recording contains everything of interest.
    private const int LongestFixture = 12 * 1024;

    /// <summary>Loads a corpus.</summary>
    /// <param name="kind">The kind.</param>
    /// <param name="data">A folder of recordings and streams, or null.</param>
    public static Corpus Load(CorpusKind kind, string? data) => kind switch
    {
        CorpusKind.Packets => With(PacketFixtures.Create(), PacketFixtures.Words, Find(data, "*.bin")),
        CorpusKind.Commands => With(CommandFixtures.Create(), CommandFixtures.Words, []),
        CorpusKind.Text => With(TextFixtures.Create(), TextFixtures.Words, Find(data, "text*.bin")),
        CorpusKind.Bvh => With(BvhFixtures.Create(), BvhFixtures.Words, Find(data, "*.bvh")),
        CorpusKind.Recordings => With(RecordingFixtures.Create(), RecordingFixtures.Words, []),
        CorpusKind.Calculation => With(CalculationFixtures.Create(), CalculationFixtures.Words, Find(data, "*.calc")),
        CorpusKind.Poses => With(PoseFixtures.Create(), PoseFixtures.Words, []),
        CorpusKind.Files => With(FileFixtures.Create(), FileFixtures.Words, []),
        _ => throw new ArgumentOutOfRangeException(nameof(kind)),
    };

    private static Corpus With(IReadOnlyList<byte[]> own, IReadOnlyList<byte[]> words, IEnumerable<string> files) =>
        new([.. own, .. files.Select(ReadStart)], own.Count, words);

    private static IEnumerable<string> Find(string? folder, string pattern) => folder is null
        ? []
        : Directory.EnumerateFiles(folder, pattern, SearchOption.AllDirectories).Order(StringComparer.Ordinal);

    private static byte[] ReadStart(string path)
    {
        using FileStream file = File.OpenRead(path);
        byte[] start = new byte[Math.Min(file.Length, LongestFixture)];
        file.ReadExactly(start);
        return start;
    }
}
