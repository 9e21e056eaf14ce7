using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;

namespace NeuronMocap.Tests.Recording;

// Listens beside a recorder, to know what it should write.
internal sealed class TapLog : IStreamListener
{
    public List<StreamConnection> Opened { get; } = [];

    public List<(int Connection, int Source, string Bytes, long Timestamp)> Pieces { get; } = [];

    public List<(int Source, string Address)> Senders { get; } = [];

    public List<string> Closed { get; } = [];

    public byte[] Bytes => Convert.FromHexString(string.Concat(Pieces.Select(piece => piece.Bytes)));

    public void OnOpened(StreamConnection connection, bool wasOpen, long timestamp) => Opened.Add(connection);

    public void OnBytes(StreamConnection connection, int source, byte[] sender, ArraySegment<byte> bytes, long timestamp)
    {
        Pieces.Add((connection.Number, source, Convert.ToHexString(bytes), timestamp));
        if (sender.Length > 0 && !Senders.Exists(known => known.Source == source))
            Senders.Add((source, Describe(sender)));
    }

    public void OnClosed(StreamConnection connection, string reason, long timestamp) => Closed.Add(reason);

    // Asserts equal pieces, to the byte and to 100 ns relative to the start.
    public void AssertRecorded(IReadOnlyList<RecordedEntry> entries)
    {
        RecordedEntry[] pieces = [.. entries.Where(entry => entry.Kind == RecordingEntryKind.Bytes)];
        Same.Items(Pieces.Select(piece => (piece.Connection, piece.Source, piece.Bytes)), pieces.Select(piece => (piece.Connection, piece.Sender, piece.Bytes)));
        for (int i = 1; i < pieces.Length; i++)
        {
            long expected = RecordingClock.Between(Pieces[0].Timestamp, Pieces[i].Timestamp).Ticks;
            Assert.InRange(pieces[i].Time - pieces[0].Time, expected - 1, expected + 1);
        }

        Assert.Equal(
            Senders,
            entries.Where(entry => entry.Kind == RecordingEntryKind.SenderAdded).Select(entry => (entry.Sender, entry.Text!)));
        Assert.Equal(Closed, entries.Where(entry => entry.Kind == RecordingEntryKind.ConnectionClosed).Select(entry => entry.Text!));
    }

    private static string Describe(byte[] sender)
    {
        var address = new SocketAddress(AddressFamily.InterNetwork, sender.Length);
        for (int i = 0; i < sender.Length; i++)
            address[i] = sender[i];

        return new IPEndPoint(IPAddress.Any, 0).Create(address).ToString()!;
    }
}
