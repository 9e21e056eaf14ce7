using System.Diagnostics;
using System.Net;
using NeuronMocap.Transport;

namespace NeuronMocap;

/// <summary>State of a reader's connection, with the reason for the last change.</summary>
/// <param name="State">The state of the connection.</param>
/// <param name="Reason">The reason; <see cref="ConnectionReason.None"/> if there is no problem.</param>
/// <param name="Message">One or two English sentences for people. They name a setting if it can solve the problem.</param>
public readonly record struct ConnectionStatus(ConnectionState State, ConnectionReason Reason, string Message)
{
    /// <summary>The local end point of the connection, or the bound UDP port; null without a connection.</summary>
    public EndPoint? LocalEndPoint { get; init; }

    /// <summary>The server's end point of a TCP connection; null without a connection, and for UDP.</summary>
    public EndPoint? RemoteEndPoint { get; init; }

    /// <summary>
    /// Size in bytes of the system's buffer for arriving datagrams; null for TCP, and while no UDP port is bound. Linux grants at most
    /// <c>net.core.rmem_max</c>, usually 212,992, and macOS limits it by <c>kern.ipc.maxsockbuf</c>. A larger burst loses datagrams.
    /// </summary>
    public int? ReceiveBufferSize { get; init; }

    /// <summary>
    /// Size in bytes that the reader requested for <see cref="ReceiveBufferSize"/>: 4,194,304; null if that is null.
    /// </summary>
    public int? RequestedReceiveBufferSize => ReceiveBufferSize is null ? null : UdpSocket.WantedBuffer;

    /// <summary>
    /// The kind of thread that receives frames and runs handlers: <see cref="ReceiveThread.Dedicated"/> or <see cref="ReceiveThread.Pool"/>; null without
    /// a connection. See <see cref="NeuronReaderOptions.ReceiveThread"/>.
    /// </summary>
    public ReceiveThread? ReceiveThread { get; init; }

    /// <summary>
    /// Format of the stream, detected from the frames of this connection; <see cref="StreamFormat.Unknown"/> before the first frame. A change during a
    /// connection causes a new status with the same state.
    /// </summary>
    public StreamFormat Format { get; init; }

    /// <summary>Number of attempts since frames last arrived, including the current attempt.</summary>
    public int Attempt { get; init; }

    /// <summary>Time until the next attempt; null unless the state is <see cref="ConnectionState.Waiting"/>.</summary>
    public TimeSpan? RetryIn { get; init; }

    /// <summary>When the change happened, in ticks of <see cref="Stopwatch"/>.</summary>
    public long Timestamp { get; init; } = Stopwatch.GetTimestamp();

    /// <summary>Whether the connection is established, regardless of what arrives.</summary>
    public bool IsConnected => State is ConnectionState.Connected or ConnectionState.Receiving or ConnectionState.Silent;

    /// <summary>Gets the state and the message.</summary>
    /// <returns>A line for a log.</returns>
    public override string ToString() => $"{State}: {Message}";
}
