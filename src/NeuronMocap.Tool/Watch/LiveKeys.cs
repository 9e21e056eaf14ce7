namespace NeuronMocap.Tool.Watch;

/// <summary>The keys of the live view, for the help.</summary>
internal static class LiveKeys
{
    private const string Title = "Keys of the live view";
    private const string Common = "q quit   tab next avatar   b next bones   c clear counters   ? help";
    private const string OfPlayback = "space pause   . , step   left, right 5 s back, forward   + - 0 speed";

    /// <summary>The keys with any source.</summary>
    public static (string Title, IReadOnlyList<string> Lines) OfWatch { get; } =
        (Title, [Common, "of a stream: r record on and off   space freeze", $"of a file: {OfPlayback}"]);

    /// <summary>The keys with a file.</summary>
    public static (string Title, IReadOnlyList<string> Lines) OfPlay { get; } = (Title, [Common, OfPlayback]);
}
