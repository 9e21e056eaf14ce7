using System.IO.Pipelines;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <content>What only the .NET build has.</content>
public abstract partial class ByteSource
{
    /// <summary>
    /// Creates a source that opens pipes, such as the inputs of connections in ASP.NET Core. The reader reads packets in the segments of a pipe, without a
    /// copy.
    /// </summary>
    /// <param name="open">
    /// Opens a new pipe, as <see cref="OpenAsync"/> opens a stream. The reader completes the pipe when its bytes end, when reading fails, and when the
    /// reader stops.
    /// </param>
    /// <param name="name">The name of the source in status messages, metrics and logs.</param>
    /// <returns>A source for any number of readers, if <paramref name="open"/> returns another pipe at each call.</returns>
    /// <exception cref="ArgumentNullException">The function is null.</exception>
    /// <exception cref="ArgumentException">The name is empty.</exception>
    public static ByteSource FromPipes(Func<CancellationToken, ValueTask<PipeReader>> open, string name = "the pipe")
    {
        ArgumentNullException.ThrowIfNull(open);
        ArgumentException.ThrowIfNullOrWhiteSpace(name);
        return new PipeSource(open, name);
    }
}
