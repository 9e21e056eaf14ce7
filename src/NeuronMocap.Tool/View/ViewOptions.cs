using System.Net;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.View;

/// <summary>Settings of a viewer, from the command line.</summary>
/// <param name="Source">The source.</param>
/// <param name="Connection">The connection to the source. For a file, it has no meaning.</param>
internal sealed record ViewOptions(Source Source, ConnectionOptions Connection)
{
    /// <summary>The port if none is given. If it is taken, the next free one is used.</summary>
    public const int DefaultPort = 7080;

    /// <summary>The largest file that a browser may send, in megabytes, if nothing else is given.</summary>
    public const int DefaultUploadMegabytes = 512;

    /// <summary>The port; null for <see cref="DefaultPort"/> or the next free one.</summary>
    public int? Port { get; init; }

    /// <summary>The address of this computer to listen on.</summary>
    public IPAddress Bind { get; init; } = IPAddress.Loopback;

    /// <summary>The word that browsers must send; null for none on this computer, and a new one for other computers.</summary>
    public string? Token { get; init; }

    /// <summary>Whether the browser is started.</summary>
    public bool Open { get; init; }

    /// <summary>The folder for recordings; null for the current one.</summary>
    public string? RecordFolder { get; init; }

    /// <summary>The largest file that a browser may send, in megabytes.</summary>
    public int UploadMegabytes { get; init; } = DefaultUploadMegabytes;

    /// <summary>The origins under which a proxy shows the page.</summary>
    public IReadOnlyList<string> AllowedOrigins { get; init; } = [];

    /// <summary>Whether a token is made if none is given.</summary>
    public bool NeedsToken => IsPublic || AllowedOrigins.Count > 0;

    /// <summary>Whether computers other than this one can reach the page.</summary>
    public bool IsPublic => !IPAddress.IsLoopback(Bind);

    /// <summary>Describes a value that this computer does not allow. Null if there is none.</summary>
    public string? FindFault() => RecordFolder is { } folder && !Directory.Exists(folder) ? $"--record-folder: there is no folder '{folder}'." : null;
}
