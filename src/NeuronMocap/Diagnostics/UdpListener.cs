using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Diagnostics;

// Listens on a UDP port of this computer for a short time. Unlike the reader's link, it records the senders and the sizes of their datagrams.
internal sealed class UdpListener(LinkOptions options, SenderFilter filter, StreamSample sample) : IDisposable
{
    private const int MaxDatagram = 65_536;
    private const int MaxSenders = 16;

    private readonly HashSet<IPEndPoint> _senders = [];
    private Socket? _socket;

    public IEnumerable<string> Senders => _senders.Select(static sender => sender.ToString());

    public int LargestDatagram { get; private set; }

    // Valid after Open.
    public int Port { get; private set; }

    // Valid after Open; null if the system does not report it.
    public int? ReceiveBufferSize { get; private set; }

    public ConnectionReason Open()
    {
        try
        {
            _socket = UdpSocket.Open(options);
            Port = ((IPEndPoint)_socket.LocalEndPoint!).Port;
            ReceiveBufferSize = UdpSocket.ReadBuffer(_socket);
            return ConnectionReason.None;
        }
        catch (SocketException exception)
        {
            return SocketErrors.ToReason(exception.SocketErrorCode);
        }
    }

    // Runs until the socket is closed.
    public async Task ReceiveAsync()
    {
        var senders = new UdpSenders(new PacketScanner(options.MaxValues), sample, filter);
        byte[] buffer = new byte[MaxDatagram];
        EndPoint anyone = new IPEndPoint(_socket!.AddressFamily == AddressFamily.InterNetwork ? IPAddress.Any : IPAddress.IPv6Any, 0);
        try
        {
            while (true)
            {
                SocketReceiveFromResult result =
                    await _socket.ReceiveFromAsync(new ArraySegment<byte>(buffer), SocketFlags.None, anyone).ConfigureAwait(false);
                LargestDatagram = Math.Max(LargestDatagram, result.ReceivedBytes);
                if (_senders.Count < MaxSenders)
                    _senders.Add((IPEndPoint)result.RemoteEndPoint);

                senders.Push(result.RemoteEndPoint.Serialize(), new ArraySegment<byte>(buffer, 0, result.ReceivedBytes), Stopwatch.GetTimestamp());
            }
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            // The socket was closed, which ends every listener.
        }
    }

    public void Dispose() => _socket?.Dispose();
}
