namespace NeuronMocap.Fuzz.Inputs;

/// <summary>Fixtures to make inputs from, and words that mean something to the parser.</summary>
/// <param name="Fixtures">Valid inputs; the program's own first.</param>
/// <param name="OwnCount">How many of them are the program's own.</param>
/// <param name="Words">Tokens, keywords and numbers at edges.</param>
internal sealed record Corpus(IReadOnlyList<byte[]> Fixtures, int OwnCount, IReadOnlyList<byte[]> Words)
{
    // Of a recording of megabytes its start has all there is to it.
    private const int LongestFixture = 12 * 1024;

    /// <summary>Makes a corpus.</summary>
    /// <param name="kind">Which one.</param>
    /// <param name="data">A folder of recordings and streams; null without.</param>
    public static Corpus Load(CorpusKind kind, string? data) => kind switch
    {
        CorpusKind.Packets => With(PacketFixtures.Create(), PacketFixtures.Words, Find(data, "*.bin")),
        CorpusKind.Commands => With(CommandFixtures.Create(), CommandFixtures.Words, []),
        CorpusKind.Text => With(TextFixtures.Create(), TextFixtures.Words, Find(data, "text*.bin")),
        CorpusKind.Bvh => With(BvhFixtures.Create(), BvhFixtures.Words, Find(data, "*.bvh")),
        CorpusKind.Recordings => With(RecordingFixtures.Create(), RecordingFixtures.Words, []),
        CorpusKind.Calculation => With(CalculationFixtures.Create(), CalculationFixtures.Words, Find(data, "*.calc")),
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
