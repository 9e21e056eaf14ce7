using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>Sends to one UDP destination. A datagram never carries bytes of two packets.</summary>
/// <remarks>
/// It cuts a packet or a line of text larger than the fragment size. Axis Neuron on macOS does the same: 1024 bytes, then the rest
/// (protocol.md section 4.2).
/// </remarks>
internal sealed class UdpRecipient : NetworkRecipient, IDirectRecipient
{
    // Maximum size of a datagram over IPv4.
    private const int MaxDatagram = 65_507;

    // Microseconds. A socket is closed no later than this after a stop.
    private const int WaitForRoom = 50_000;

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

        // The log can only repeat whole units, so a destination that had no room must not have got a part of one.
        if (!stream.IsDirect || (stream.Content.PacketsPerFrame > 1 && !stream.IsPacketwise))
            return;

        socket.Blocking = false;
        feed.Attach(this);
    }

    bool IDirectRecipient.IsReady => true;

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

    // Runs on the publishing thread while this recipient's thread waits in ReadFeed. Each unit is a packet.
    int IDirectRecipient.Take(UnitBatch units, int packets, int first)
    {
        int taken = 0;
        try
        {
            while (taken < units.Count && TrySendPacket(units.Bytes, units.StartOf(taken), units.EndOf(taken), Plan.IsMotion(first), mayWait: false))
                taken++;
        }
        catch (ObjectDisposedException)
        {
            // The broadcaster has stopped. Its thread ends the recipient.
        }

        return taken;
    }

    protected override bool SendAll()
    {
        FrameBatch batch;
        while ((batch = ReadFeed(_buffer)).Bytes > 0 || !Feed.HasEnded)
        {
            int offset = 0;
            for (int i = 0; i < batch.Packets; i++)
            {
                bool isMotion = Plan.IsMotion(batch.First + i);
                int end = offset + Plan.MeasurePacket(_buffer.AsSpan(offset, batch.Bytes - offset), isMotion);
                TrySendPacket(_buffer, offset, end, isMotion, mayWait: true);
                offset = end;
            }
        }

        return Feed.IsAtEnd;
    }

    // Returns false if nothing was sent, because the system has no room and mayWait is false.
    private bool TrySendPacket(byte[] bytes, int start, int end, bool isMotion, bool mayWait)
    {
        for (int offset = start; offset < end;)
        {
            int length = Math.Min(end - offset, _fragment);
            SocketError error = Send(bytes, offset, length, mayWait);
            if (error == SocketError.WouldBlock && offset == start && !mayWait)
                return false;

            if (error != SocketError.Success)
            {
                CountLostPacket();
                return true;
            }

            offset += length;
            CountBytes(length);
        }

        if (isMotion)
            _motionPackets++;
        else
            _calculationPackets++;

        SetFrames(_motionPackets, _calculationPackets);
        return true;
    }

    // The error "refused" reports that nobody received an earlier datagram, and it keeps this datagram from being sent. The second attempt sends it.
    private SocketError Send(byte[] bytes, int offset, int length, bool mayWait)
    {
        while (true)
        {
            _socket.Send(bytes, offset, length, SocketFlags.None, out SocketError error);
            if (error is SocketError.ConnectionRefused or SocketError.ConnectionReset)
                _socket.Send(bytes, offset, length, SocketFlags.None, out error);
            if (error != SocketError.WouldBlock || !mayWait || _socket.Blocking)
                return error;

            _socket.Poll(WaitForRoom, SelectMode.SelectWrite);
        }
    }
}
