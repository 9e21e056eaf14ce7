using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>Sends to one UDP destination. A datagram never carries bytes of two packets.</summary>
/// <remarks>
/// A packet or a line of text larger than the fragment size is cut, as Axis Neuron on macOS does: 1024 bytes, then the rest (protocol.md section
/// 4.2).
/// </remarks>
internal sealed class UdpRecipient : NetworkRecipient
{
    // Maximum size of a datagram over IPv4.
    private const int MaxDatagram = 65_507;

    private readonly Socket _socket;
    private readonly int _fragment;
    private readonly byte[] _buffer;
    private long _motionPackets;
    private long _calculationPackets;

    public UdpRecipient(
        Socket socket,
        IPEndPoint destination,
        BroadcastStream stream,
        FrameFeed feed,
        int? fragment,
        Action<Recipient, Exception?> ended,
        FaultReport report)
        : base(destination, stream, feed, ended, report)
    {
        _socket = socket;
        _fragment = Math.Min(fragment ?? MaxDatagram, MaxDatagram);
        _buffer = new byte[ReadSize];
    }

    /// <summary>Opens a socket that sends to a destination.</summary>
    /// <exception cref="SocketException">No route leads to the destination.</exception>
    public static Socket Connect(IPEndPoint destination)
    {
        var socket = new Socket(destination.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
        try
        {
            if (destination.AddressFamily == AddressFamily.InterNetwork)
                socket.EnableBroadcast = true;
            socket.Connect(destination);
            return socket;
        }
        catch
        {
            socket.Dispose();
            throw;
        }
    }

    public override void Dispose() => _socket.Dispose();

    protected override bool SendAll()
    {
        FrameBatch batch;
        while ((batch = ReadFeed(_buffer)).Bytes > 0)
        {
            int offset = 0;
            for (int i = 0; i < batch.Packets; i++)
                offset = SendPacket(offset, batch.Bytes, Plan.IsMotion(batch.First + i));
        }

        return Feed.IsAtEnd;
    }

    // Returns where the next packet starts.
    private int SendPacket(int offset, int filled, bool isMotion)
    {
        int end = offset + Plan.MeasurePacket(_buffer.AsSpan(offset, filled - offset), isMotion);
        while (offset < end)
        {
            int length = Math.Min(end - offset, _fragment);
            if (!TrySend(offset, length))
            {
                CountLostPacket();
                return end;
            }

            offset += length;
            CountBytes(length);
        }

        if (isMotion)
            _motionPackets++;
        else
            _calculationPackets++;

        SetFrames(_motionPackets, _calculationPackets);

        return end;
    }

    // The error "refused" reports that nobody received an earlier datagram, and it keeps this datagram from being sent. The second attempt sends it.
    private bool TrySend(int offset, int length)
    {
        _socket.Send(_buffer, offset, length, SocketFlags.None, out SocketError error);
        if (error is SocketError.ConnectionRefused or SocketError.ConnectionReset)
            _socket.Send(_buffer, offset, length, SocketFlags.None, out error);

        return error == SocketError.Success;
    }
}
