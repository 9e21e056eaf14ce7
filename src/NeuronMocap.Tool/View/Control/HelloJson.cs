using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Control;

/// <summary>The first thing that the page gets.</summary>
/// <param name="Name">The name of the program.</param>
/// <param name="Version">The version of the program.</param>
/// <param name="Mode">"live" or "take".</param>
/// <param name="Source">The source as on the command line, without a password.</param>
/// <param name="Take">The id of the take that is open; null for none.</param>
/// <param name="CanCommand">Whether the page can send commands to the source.</param>
/// <param name="UploadLimit">The largest take that a page may send, in bytes.</param>
/// <param name="Performers">The performers that are known.</param>
internal sealed record HelloJson(
    string Name, string Version, string Mode, string Source, string? Take, bool CanCommand, long UploadLimit, IReadOnlyList<PerformerJson> Performers)
{
    /// <summary>The kind of a message on /control.</summary>
    public string Type { get; } = "hello";
}
