using System.Diagnostics;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Output;

/// <summary>A file that cannot be written any more, while the stream continues.</summary>
/// <param name="Kind">"recording" or "export".</param>
/// <param name="File">The file, as the command line names it.</param>
/// <param name="Reason">The reason in words.</param>
/// <param name="Lost">Pieces of a recording, or frames of an export, that arrived but were not written.</param>
/// <param name="Timestamp">Time of the report, in ticks of <see cref="Stopwatch"/>.</param>
internal sealed record FileFailure(string Kind, string File, string Reason, long Lost, long Timestamp)
{
    private const string Export = "export";
    private const string Recording = "recording";

    /// <summary>Whether <see cref="Lost"/> counts frames instead of pieces.</summary>
    public bool IsExport => string.Equals(Kind, Export, StringComparison.Ordinal);

    /// <summary>"Recording failed: ...". The reason comes first, because a terminal may be narrow.</summary>
    public string Text => $"{char.ToUpperInvariant(Kind[0])}{Kind[1..]} failed: {TerminalText.Clean(Reason)}";

    /// <summary>"RECORDING FAILED: the disk is full.", for a conspicuous line.</summary>
    public string Alarm => $"{Kind.ToUpperInvariant()} FAILED: {TerminalText.Clean(Reason)}";

    /// <summary>Creates the failure of a recording that could not start.</summary>
    public static FileFailure OfRecording(string file, string reason) => new(Recording, file, reason, 0, Stopwatch.GetTimestamp());

    /// <summary>Gets the failure that an event reports. Null for other events.</summary>
    public static FileFailure? Of(ReaderEvent news) => news.Id switch
    {
        ReaderEventId.RecordingFailed => new FileFailure(Recording, news.Subject!, ReasonOf(news), news.Count, Stopwatch.GetTimestamp()),
        ReaderEventId.ExportFailed => new FileFailure(Export, news.Subject!, ReasonOf(news), news.Count, Stopwatch.GetTimestamp()),
        _ => null,
    };

    // The name of the file would push the important part out of a narrow window.
    private static string ReasonOf(ReaderEvent news) =>
        FileFault.IsDiskFull(news.Exception!) ? "the disk is full." : FileFault.OfWriting(news.Exception!, news.Subject!);
}
