using System.IO.Pipelines;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <content>What only the .NET build has.</content>
public sealed partial class NeuronReader
{
    /// <summary>
    /// Creates a reader for a pipe, such as the input of a connection in ASP.NET Core. Packets are read in the segments of the pipe, without a copy.
    /// </summary>
    /// <remarks>
    /// The reader ends when the pipe ends or fails, whatever its reconnect policy says. Bytes go back to the pipe after the handlers of their frames have
    /// returned, so the writer of the pipe waits for slow handlers. The reader receives on the threads of the pipe, usually pool threads.
    /// </remarks>
    /// <param name="pipe">
    /// Delivers the bytes that a server would send over TCP. Nothing else may read it. The reader completes it at its end, once a pending read has ended.
    /// </param>
    /// <param name="options">How to receive; copied; null for the defaults. Its <see cref="NeuronReaderOptions.Source"/> has no effect.</param>
    /// <exception cref="ArgumentException">An option is out of range; the message names it.</exception>
    public NeuronReader(PipeReader pipe, NeuronReaderOptions? options = null)
        : this((options ?? new NeuronReaderOptions()).CopyFor(new SinglePipeSource(pipe ?? throw new ArgumentNullException(nameof(pipe)))), createLink: null)
    {
    }
}
