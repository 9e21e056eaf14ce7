using NeuronMocap.Delivery;
using NeuronMocap.Transport;

namespace NeuronMocap.Monitor;

/// <summary>The one line on standard error when a run ends without a frame.</summary>
internal static class FailureMessage
{
    public static string Describe(ConnectionStatus status, ReaderStatistics statistics)
    {
        // The connection ended before the reader's silence check could say what the bytes were.
        if (statistics.SkippedBytes > 0 && status.Reason is ConnectionReason.ClosedByPeer or ConnectionReason.None)
        {
            return $"{statistics.SkippedBytes} bytes arrived, but no packet of this protocol. Check the port, and that the server's "
                + "broadcasting format (block type) is Binary.";
        }

        string message = TerminalText.Clean(status.Message);
        return status.Reason == ConnectionReason.None
            ? $"No frame has arrived. {message} Check the server's address and port, and that its broadcasting is on."
            : message;
    }
}
