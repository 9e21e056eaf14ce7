using System.Text.Json.Serialization;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>A take as the page gets it. Times are milliseconds since its start.</summary>
/// <param name="Id">The id.</param>
/// <param name="Name">Name of the file.</param>
/// <param name="Kind">"bvh", "nmrec", "calc" or "raw".</param>
/// <param name="Duration">Time of the last frame that is known.</param>
/// <param name="Progress">How much of the file was read, 0 to 1.</param>
/// <param name="Performers">The performers.</param>
/// <param name="Problems">What is wrong with the file, in sentences.</param>
internal sealed record TakeJson(string Id, string Name, string Kind, double Duration, double Progress, IReadOnlyList<TakePerformerJson> Performers, IReadOnlyList<string> Problems)
{
    public static TakeJson Of(Take take) => new(
        take.Id,
        take.Name,
        KindOf(take.Kind),
        take.Duration.TotalMilliseconds,
        take.Progress,
        [.. take.Performers.Select(TakePerformerJson.Of)],
        take.Problems);

    private static string KindOf(FileKind kind) => kind switch
    {
        FileKind.Bvh => "bvh",
        FileKind.Recording => "nmrec",
        FileKind.Calculation => "calc",
        _ => "raw",
    };
}

/// <summary>A performer of a take.</summary>
/// <param name="Performer">As in a live stream.</param>
/// <param name="Frames">Number of frames that can be read.</param>
/// <param name="Start">Time of the first frame.</param>
/// <param name="End">Time of the last frame.</param>
/// <param name="Rate">Frames per second; null if unknown.</param>
/// <param name="Gaps">Start and end of each time without frames.</param>
internal sealed record TakePerformerJson(PerformerJson Performer, long Frames, double Start, double End, double? Rate, IReadOnlyList<double[]> Gaps)
    : PerformerJson(Performer)
{
    private const double Microseconds = 1000; // in a millisecond

    [JsonIgnore]
    public PerformerJson Performer { get; init; } = Performer;

    public static TakePerformerJson Of(TakePerformer performer)
    {
        Performer known = Describe(performer);
        bool isEmpty = performer.Frames == 0;
        return new TakePerformerJson(
            known.ToJson() with { Key = performer.Key },
            performer.Frames,
            isEmpty ? 0 : performer.Times.Start / Microseconds,
            isEmpty ? 0 : performer.Times.End / Microseconds,
            performer.Rate,
            Milliseconds(performer.Times.GetGaps()));
    }

    /// <summary>Converts stretches to pairs of milliseconds.</summary>
    public static IReadOnlyList<double[]> Milliseconds(IEnumerable<TimeStretch> stretches) =>
        [.. stretches.Select(static stretch => new[] { stretch.From / Microseconds, stretch.To / Microseconds })];

    /// <summary>Describes a performer as one of a live stream.</summary>
    public static Performer Describe(TakePerformer performer) => new(new PerformerKey(0, performer.Index), performer.Name, performer.Index, performer.Body);
}
