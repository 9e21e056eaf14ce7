using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Runtime.CompilerServices;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Cuts what a reader receives into units, once for all broadcasters that send it on.</summary>
/// <remarks>
/// It sees the bytes before the reader parses them, so nothing of a packet changes. It listens while there is a broadcaster. A new object listens when the
/// first broadcaster comes again: the old one may still get a piece at that moment.
/// </remarks>
internal sealed class ReaderUnits : IStreamListener
{
    private static readonly ConditionalWeakTable<NeuronReader, Holder> Holders = new();

    private readonly UnitParser _parser;
    private volatile IUnitListener[] _listeners = [];
    private SocketAddress? _sender;
    private long _incompletePackets;

    private ReaderUnits(int maxValues) => _parser = new UnitParser(maxValues, keepsIncomplete: false);

    /// <summary>Adds a listener, which gets the units that are complete from now on.</summary>
    public static void Add(NeuronReader reader, IUnitListener listener)
    {
        Holder holder = Holders.GetValue(reader, static _ => new Holder());
        lock (holder)
        {
            bool isFirst = holder.Units is null;
            ReaderUnits units = holder.Units ??= new ReaderUnits(reader.MaxValues);
            units._listeners = [.. units._listeners, listener];
            if (isFirst)
                reader.Tap.Add(units, Stopwatch.GetTimestamp());
        }
    }

    /// <summary>Removes a listener, if it was added. It may still get the units of a piece that arrives at this moment.</summary>
    public static void Remove(NeuronReader reader, IUnitListener listener)
    {
        if (!Holders.TryGetValue(reader, out Holder? holder))
            return;

        lock (holder)
        {
            if (holder.Units is not { } units)
                return;

            units._listeners = [.. units._listeners.Where(other => other != listener)];
            if (units._listeners.Length > 0)
                return;

            holder.Units = null;
            reader.Tap.Remove(units);
        }
    }

    void IStreamListener.OnOpened(StreamConnection connection, bool wasOpen, long timestamp)
    {
        Follow(Describe(RecordedEventKind.Opened, connection, timestamp) with { WasOpen = wasOpen });
        if (wasOpen || connection.IsCalculation)
            return;

        foreach (IUnitListener listener in _listeners)
            listener.OnConnected();
    }

    void IStreamListener.OnBytes(StreamConnection connection, int number, byte[] sender, ArraySegment<byte> bytes, long timestamp) =>
        Follow(Describe(RecordedEventKind.Bytes, connection, timestamp) with
        {
            Bytes = bytes,
            Sender = connection.IsDatagrams ? FindSender(sender) : null,
        });

    void IStreamListener.OnClosed(StreamConnection connection, string reason, long timestamp) =>
        Follow(Describe(RecordedEventKind.Closed, connection, timestamp));

    private static RecordedEvent Describe(RecordedEventKind kind, StreamConnection connection, long timestamp) =>
        new(kind, TimeSpan.FromSeconds(timestamp / (double)Stopwatch.Frequency))
        {
            Transport = connection.IsDatagrams ? TransportKind.Udp : TransportKind.Tcp,
            Connection = connection.Number,
            IsCalculation = connection.IsCalculation,
        };

    // The parser copies the address of a sender that it keeps.
    private SocketAddress FindSender(byte[] sender)
    {
        if (_sender?.Size != sender.Length)
            _sender = new SocketAddress(AddressFamily.InterNetwork, sender.Length);

        for (int i = 0; i < sender.Length; i++)
            _sender[i] = sender[i];

        return _sender;
    }

    private void Follow(in RecordedEvent received)
    {
        try
        {
            _parser.Follow(received);
        }
        catch (Exception exception)
        {
            // The system is out of memory. The reader goes on, and so does the relay, with the next packet.
            foreach (IUnitListener listener in _listeners)
                listener.OnFailed(exception);
        }

        long incomplete = _parser.IncompletePackets;
        int added = (int)(incomplete - _incompletePackets);
        _incompletePackets = incomplete;
        if (added == 0 && _parser.Units.Count == 0)
            return;

        foreach (IUnitListener listener in _listeners)
            listener.OnUnits(_parser.Units, added);
    }

    private sealed class Holder
    {
        public ReaderUnits? Units { get; set; }
    }
}
