using System.Diagnostics;
using System.Net;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// One assembler for every address and port that sends to a UDP port. Axis Neuron on macOS splits a frame into two datagrams, and datagrams of two senders
// interleave (protocol.md section 4.2). UdpServers decides which of them are the same server. Used by the receive loop, and by a timer that takes turns
// with it.
internal sealed class UdpSenders : IPacketReceiver
{
    // Thousands of sender addresses can be forged. A sender that delivers frames keeps its place. Of the other senders, the one that was silent longest is
    // removed.
    public const int Limit = 64;

    // Servers that split frames use pieces of this size (protocol.md sections 4.2 and 8). A larger datagram therefore begins with a frame.
    private const int PieceSize = 1024;

    // Limit for waiting datagrams: what 100 avatars send in half a second.
    private const int MaxHeldBytes = 4 * 1024 * 1024;

    private static readonly long KeptAfterFrame = 5 * Stopwatch.Frequency;

    private readonly PacketScanner _scanner;
    private readonly IPacketReceiver _receiver;
    private readonly SenderFilter _filter;
    private readonly UdpServers _servers;
    private readonly object? _receiveLock;
    private readonly bool _isCalculationPort;
    private readonly SenderProbe _probe;
    private readonly StreamTap? _tap;
    private readonly PacketAssembler _strays;
    private readonly Dictionary<SocketAddress, UdpSender> _senders = new(SenderComparer.Instance);

    // Senders that wait for a server, in the order of arrival.
    private readonly List<UdpSender> _unassigned = [];
    private UdpSender? _stray;
    private UdpSender? _current;
    private long _heldBytes;
    private long _clock;

    // The two ports of a reader share the servers and the receive lock, which separates their threads.
    public UdpSenders(
        PacketScanner scanner,
        IPacketReceiver receiver,
        SenderFilter filter,
        UdpServers? servers = null,
        object? receiveLock = null,
        StreamTap? tap = null)
    {
        (_scanner, _receiver, _filter, _servers, _receiveLock) = (scanner, receiver, filter, servers ?? new UdpServers(), receiveLock);
        _probe = new SenderProbe(scanner);
        _tap = tap;
        _isCalculationPort = receiver is CalculationOnlyReceiver;
        _strays = new PacketAssembler(scanner, receiver);
    }

    // Number of senders that have a server.
    public int Count => _senders.Count - _unassigned.Count;

    // Whether datagrams wait. Settle must then be called from time to time, because no other datagrams may arrive.
    public bool IsWaiting => _unassigned.Count > 0;

    // Called in the receive loop when datagrams begin to wait.
    public Action? Waits { get; set; }

    public void Push(SocketAddress address, ArraySegment<byte> datagram, long timestamp) => Push(address, datagram, timestamp, clock: timestamp);

    // The clock measures silences; a playback has its own clock.
    public void Push(SocketAddress address, ArraySegment<byte> datagram, long timestamp, long clock)
    {
        if (_receiveLock is null)
        {
            Take(address, datagram, timestamp, clock);
            return;
        }

        lock (_receiveLock)
            Take(address, datagram, timestamp, clock);
    }

    private void Take(SocketAddress address, ArraySegment<byte> datagram, long timestamp, long clock)
    {
        _clock = clock;
        long turn = _servers.NextTurn();
        if (!_senders.TryGetValue(address, out UdpSender? sender) || sender.IsRetired)
        {
            AddSender(address, datagram, timestamp, turn);
            return;
        }

        _tap?.OnBytes(sender.Number, sender.AddressBytes, datagram, timestamp);
        long before = sender.Turn;
        sender.Hear(turn, clock);
        if (sender.Assembler is null)
        {
            Hold(sender, datagram, timestamp);
            return;
        }

        // Waiting datagrams arrived before this one.
        if (_unassigned.Count > 0)
            SettleAlone(clock, isLast: false, sender, before);

        Deliver(sender, datagram, timestamp);
    }

    // Delivers the datagrams of senders that can now be identified; at the end, of all senders.
    public void Settle(long clock, bool isLast = false)
    {
        if (_receiveLock is null)
        {
            SettleAlone(clock, isLast);
            return;
        }

        lock (_receiveLock)
            SettleAlone(clock, isLast);
    }

    // speaker: the sender of the current datagram; before: the turn of its previous datagram. Checks only senders that this may identify, because a flood
    // has many.
    private void SettleAlone(long clock, bool isLast, UdpSender? speaker = null, long before = 0)
    {
        _clock = clock;
        isLast |= _heldBytes > MaxHeldBytes;
        for (int i = 0; i < _unassigned.Count;)
        {
            UdpSender sender = _unassigned[i];
            bool isDue = isLast || clock > sender.Due || (speaker is not null && before < sender.Began && speaker.Host == sender.Host);
            if (isDue && _servers.TryPlace(sender, IsCalculation(sender), clock, isLast, out UdpSender? replaced))
                Release(sender, replaced, speaker);
            else
                i++;
        }
    }

    void IPacketReceiver.OnPacket(in ReceivedPacket packet)
    {
        UdpSender sender = _current!;
        if (!packet.IsFrame)
        {
            _receiver.OnPacket(packet);
            return;
        }

        sender.Delivered = _clock;
        int kind = 1 << (int)packet.Kind;
        if ((sender.Kinds & kind) == 0 && !_isCalculationPort && IsOther(sender, kind, packet.Kind != PacketKind.Motion))
            _receiver.OnPacket(new ReceivedPacket(packet.Kind, packet.Array, packet.Offset, packet.Length, packet.Timestamp, sender.Assembler!.Origin));
        else
            _receiver.OnPacket(packet);
    }

    void IPacketReceiver.OnText(ReadOnlySpan<byte> bytes, PacketKind kind) => _receiver.OnText(bytes, kind);

    void IPacketReceiver.OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason) => _receiver.OnSkipped(bytes, reason);

    // On a calculation port, all data is calculation data.
    private bool IsCalculation(UdpSender sender) => _isCalculationPort || sender.Identity.IsCalculation;

    private void Deliver(UdpSender sender, ArraySegment<byte> datagram, long timestamp)
    {
        PacketAssembler assembler = sender.Assembler!;
        _current = sender;

        // A datagram that begins with a header cannot be the rest of the previous packet, so that rest was lost. Joining the two would make one frame out
        // of parts of two.
        if (assembler.PendingBytes > 0 && (_scanner.StartsPacket(datagram) || assembler.StartsAnew(datagram)))
            assembler.Abandon();

        assembler.Push(datagram, timestamp);
    }

    // Handles a datagram of an unknown sender.
    private void AddSender(SocketAddress address, ArraySegment<byte> datagram, long timestamp, long turn)
    {
        if (!_filter.Allows(address))
        {
            _filter.CountRefused(address);
            return;
        }

        SenderIdentity? start = _probe.Find(datagram);
        bool isCrowded = start is not null && Count >= Limit && FindDispensable() is null && !_servers.Knows(HostKey.Of(address));
        if (start is not { } found || isCrowded)
        {
            TapStray(address, datagram, timestamp);
            Skip(datagram, timestamp, isCrowded);
            return;
        }

        Forget(address);
        var sender = new UdpSender(address, _servers.NextNumber(), found, turn, _clock);
        _tap?.OnBytes(sender.Number, sender.AddressBytes, datagram, timestamp);
        if (_unassigned.Count == Limit)
            GiveUp(_unassigned.Aggregate(static (oldest, other) => other.Turn < oldest.Turn ? other : oldest));

        _senders.Add(sender.Address, sender);
        _unassigned.Add(sender);
        Hold(sender, datagram, timestamp);
        if (_unassigned.Count > 0)
            Waits?.Invoke();
    }

    private void Hold(UdpSender sender, ArraySegment<byte> datagram, long timestamp)
    {
        sender.Held.Add((datagram.AsSpan().ToArray(), timestamp));
        _heldBytes += datagram.Count;
        SettleAlone(_clock, isLast: false);
    }

    private void Release(UdpSender sender, UdpSender? replaced, UdpSender? speaker)
    {
        _unassigned.Remove(sender);
        (byte[] Datagram, long Timestamp)[] held = TakeHeld(sender);
        replaced?.Assembler!.Abandon();
        if (Count > Limit && !TryMakeRoom(sender, speaker))
        {
            _servers.Remove(sender);
            _senders.Remove(sender.Address);
            foreach ((byte[] datagram, long timestamp) in held)
                Skip(new ArraySegment<byte>(datagram), timestamp, isCrowded: true);

            return;
        }

        sender.Assembler = new PacketAssembler(_scanner, this) { Origin = OriginOf(sender) };
        if (held[0].Datagram.Length <= PieceSize)
            sender.Assembler.JoinLate();

        foreach ((byte[] datagram, long timestamp) in held)
            Deliver(sender, new ArraySegment<byte>(datagram), timestamp);
    }

    private bool IsOther(UdpSender sender, int kind, bool isCalculation)
    {
        sender.Kinds |= kind;
        if (!_servers.Learn(sender, isCalculation, _clock, out UdpSender? replaced))
            return false;

        replaced?.Assembler!.Abandon();
        sender.Assembler!.Origin = OriginOf(sender);
        return true;
    }

    private static int OriginOf(UdpSender sender) => PacketOrigin.Create(sender.Server!.Number, sender.Server.Run);

    private bool TryMakeRoom(UdpSender newcomer, UdpSender? speaker)
    {
        if (FindDispensable(newcomer, speaker) is not { } sender)
            return false;

        _current = sender;
        sender.Assembler!.Abandon();
        _servers.Remove(sender);
        _senders.Remove(sender.Address);
        return true;
    }

    // Finds the sender that was silent longest among those that deliver no frames; null if all deliver. The speaker keeps its place until its datagram is
    // processed.
    private UdpSender? FindDispensable(UdpSender? newcomer = null, UdpSender? speaker = null)
    {
        UdpSender? oldest = null;
        foreach (UdpSender sender in _senders.Values)
        {
            bool isKept = sender == newcomer || sender == speaker || sender.Assembler is null || (!sender.IsRetired && sender.Delivered is { } delivered && _clock - delivered <= KeptAfterFrame);
            if (!isKept && (oldest is null || sender.Turn < oldest.Turn))
                oldest = sender;
        }

        return oldest;
    }

    // Removes a sender that was replaced and now sends again.
    private void Forget(SocketAddress address)
    {
        if (_senders.TryGetValue(address, out UdpSender? retired))
            _senders.Remove(retired.Address);
    }

    private void GiveUp(UdpSender newcomer)
    {
        _unassigned.Remove(newcomer);
        _senders.Remove(newcomer.Address);
        foreach ((byte[] datagram, long timestamp) in TakeHeld(newcomer))
            Skip(new ArraySegment<byte>(datagram), timestamp, isCrowded: true);
    }

    private (byte[] Datagram, long Timestamp)[] TakeHeld(UdpSender sender)
    {
        (byte[] Datagram, long Timestamp)[] held = [.. sender.Held];
        sender.Held.Clear();
        sender.Held.Capacity = 0;
        foreach ((byte[] datagram, _) in held)
            _heldBytes -= datagram.Length;

        return held;
    }

    private void Skip(ArraySegment<byte> datagram, long timestamp, bool isCrowded)
    {
        if (isCrowded)
        {
            _receiver.OnSkipped(datagram, SkipReason.TooManySenders);
            return;
        }

        if (datagram.Count > PieceSize)
            _strays.BeginAnew();

        _strays.Push(datagram, timestamp);
        _strays.Abandon();
    }

    // A recording also contains bytes outside packets, with their sender.
    private void TapStray(SocketAddress address, ArraySegment<byte> datagram, long timestamp)
    {
        if (_tap is not { IsListened: true })
            return;

        if (_stray is null || !SenderComparer.Instance.Equals(_stray.Address, address))
            _stray = new UdpSender(address, _servers.NextNumber(), default, turn: 0, clock: 0);

        _tap.OnBytes(_stray.Number, _stray.AddressBytes, datagram, timestamp);
    }
}
