using System.Diagnostics;
using System.Net;

namespace NeuronMocap;

/// <summary>State of a reader's connection, with the reason of the last change.</summary>
/// <param name="State">What the connection is doing.</param>
/// <param name="Reason">Why; <see cref="ConnectionReason.None"/> when nothing went wrong.</param>
/// <param name="Message">One or two English sentences for people; where a setting can help, they name it.</param>
public readonly record struct ConnectionStatus(ConnectionState State, ConnectionReason Reason, string Message)
{
    /// <summary>This machine's side of the connection, or the bound UDP port; null while there is none.</summary>
    public EndPoint? LocalEndPoint { get; init; }

    /// <summary>The server's side of a TCP connection; null while there is none, and for UDP.</summary>
    public EndPoint? RemoteEndPoint { get; init; }

    /// <summary>
    /// Bytes that the system keeps of arriving datagrams until they are read; null for TCP, and while no UDP port is bound. The reader asks for
    /// 4,194,304. Linux grants no more than <c>net.core.rmem_max</c>, usually 212,992: a burst that is larger loses datagrams.
    /// </summary>
    public int? ReceiveBufferSize { get; init; }

    /// <summary>
    /// On which thread frames are received and handlers run: <see cref="ReceiveThread.Dedicated"/> or
    /// <see cref="ReceiveThread.Pool"/>; null while there is no connection. See <see cref="NeuronReaderOptions.ReceiveThread"/>.
    /// </summary>
    public ReceiveThread? ReceiveThread { get; init; }

    /// <summary>
    /// What the server sends, as the frames of this connection show; <see cref="StreamFormat.Unknown"/> before the first one. When it changes in
    /// the middle of a connection, a status of the same state tells it.
    /// </summary>
    public StreamFormat Format { get; init; }

    /// <summary>Number of attempts since frames last arrived, the running one included.</summary>
    public int Attempt { get; init; }

    /// <summary>Time until the next attempt; null unless the state is <see cref="ConnectionState.Waiting"/>.</summary>
    public TimeSpan? RetryIn { get; init; }

    /// <summary>When the change happened: ticks of <see cref="Stopwatch"/>.</summary>
    public long Timestamp { get; init; } = Stopwatch.GetTimestamp();

    /// <summary>Whether the connection stands, whatever arrives over it.</summary>
    public bool IsConnected => State is ConnectionState.Connected or ConnectionState.Receiving or ConnectionState.Silent;

    /// <summary>State and message.</summary>
    /// <returns>A line for a log.</returns>
    public override string ToString() => $"{State}: {Message}";
}
