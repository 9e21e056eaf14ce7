using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Watch;

/// <summary>Finds the one line on standard error for a run that ends without a frame, or with faulty frames.</summary>
internal sealed class FailureMessage
{
    private readonly Lock _lock = new();
    private ConnectionStatus _problem;
    private ConnectionStatus _receiving;

    /// <summary>Remembers the last problem, because the run may end in the middle of the next attempt. Thread-safe.</summary>
    public void OnStatus(ConnectionStatus status)
    {
        if (status.State == ConnectionState.Receiving)
        {
            lock (_lock)
                _receiving = status;
        }

        if (status.Reason is ConnectionReason.None or ConnectionReason.Requested)
            return;

        lock (_lock)
            _problem = status;
    }

    /// <summary>Describes the problem while frames last arrived, for example with the calculation port. Null if there was none.</summary>
    public string? DescribeReceiving()
    {
        lock (_lock)
            return _receiving.Reason == ConnectionReason.None ? null : _receiving.Describe();
    }

    /// <summary>Describes what to check.</summary>
    /// <param name="status">The state at the end of the run.</param>
    /// <param name="statistics">The statistics of the reader.</param>
    public string Describe(ConnectionStatus status, ReaderStatistics statistics)
    {
        ConnectionStatus problem;
        lock (_lock)
            problem = _problem;

        if (problem.Reason == ConnectionReason.EndOfRecording)
            return $"{problem.Describe()} It holds no frames.";

        if (statistics.RejectedMessages > 0 && problem.Reason is ConnectionReason.None or ConnectionReason.NoData)
            return $"{statistics.RejectedMessages} {Quantity.Noun(statistics.RejectedMessages, "message arrived that is", "messages arrived that are")} not VMC, and no pose. Check that the other program sends VMC to this port.";

        // The run ended before the reader's silence check could identify the bytes.
        if (statistics.BytesSkipped > 0 && problem.Reason == ConnectionReason.None)
        {
            return $"{statistics.BytesSkipped} {Quantity.Noun(statistics.BytesSkipped, "byte")} arrived, but no packet of this protocol. Check the port, and that the server's "
                + "broadcasting format (block type) is Binary.";
        }

        return problem.Reason == ConnectionReason.None
            ? $"No frame has arrived. {status.Describe()} Check the server's address and port, and that its broadcasting is on."
            : problem.Describe();
    }
}
