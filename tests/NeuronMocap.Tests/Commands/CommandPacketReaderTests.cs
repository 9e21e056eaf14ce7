using NeuronMocap.Commands;
using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Commands;

public class CommandPacketReaderTests
{
    [Theory, EverySplitting]
    public void Replies_are_read_at_every_split(Splitting splitting)
    {
        byte[][] payloads = [[], [1], [.. Enumerable.Range(0, 300).Select(i => (byte)i)], [0xFF, 0xAA, 0, 0xFF, 0xBB]];
        byte[] bytes = [.. payloads.SelectMany((payload, i) => CommandScript.Packet(payload, 1001 + i))];
        foreach (IEnumerable<ArraySegment<byte>> pieces in Splits.Of(bytes, splitting))
        {
            (List<(int Id, byte[] Payload)> read, long skipped) = ReadAll(pieces, maxPayload: 300);

            Assert.Equal(payloads.Length, read.Count);
            Assert.All(read, (reply, i) => Assert.Equal(1001 + i, reply.Id));
            Assert.All(read, (reply, i) => Assert.Equal(payloads[i], reply.Payload));
            Assert.Equal(0, skipped);
        }
    }

    [Theory, EverySplitting]
    public void Noise_is_skipped_to_the_next_token_pair(Splitting splitting)
    {
        byte[] halfHeader = CommandScript.Packet([], 1001)[..15];
        byte[] garbage = [1, 0xFF, 0xFF, 0xAA, .. halfHeader, 0xFF];
        byte[] bytes = [.. garbage, .. CommandScript.Packet([7], 1003), .. garbage, .. CommandScript.Packet([8], 1003)];
        foreach (IEnumerable<ArraySegment<byte>> pieces in Splits.Of(bytes, splitting))
        {
            (List<(int Id, byte[] Payload)> read, long skipped) = ReadAll(pieces, maxPayload: 48);

            Assert.Equal([7, 8], read.Select(reply => reply.Payload[0]));
            Assert.Equal(2 * garbage.Length, skipped);
        }
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(int.MinValue)]
    [InlineData(49)]
    [InlineData(int.MaxValue)]
    public void A_size_over_the_limit_is_reported_before_buffering(int size)
    {
        var reader = new CommandPacketReader(maxPayload: 48);
        Add(reader, CommandScript.Packet([], 1003, size));

        Assert.True(reader.TryRead(out CommandChannelHeader header, out ReadOnlySpan<byte> payload));
        Assert.False(reader.IsAllowed(header));
        Assert.True(payload.IsEmpty);
    }

    [Fact]
    public void Random_pieces_match_a_whole_search()
    {
        var random = new Random(20);
        for (int round = 0; round < 300; round++)
        {
            byte[] bytes = [.. Enumerable.Range(0, random.Next(1, 6)).SelectMany(_ => AnyPart(random))];
            (List<(int Id, byte[] Payload)> expected, long skipped) = Search(bytes, maxPayload: 200);
            (List<(int Id, byte[] Payload)> actual, long actuallySkipped) = ReadAll(Splits.Random(bytes, random), maxPayload: 200);

            Assert.Equal(expected.Select(reply => reply.Id), actual.Select(reply => reply.Id));
            Assert.Equal(expected.SelectMany(reply => reply.Payload), actual.SelectMany(reply => reply.Payload));
            Assert.Equal(skipped, actuallySkipped);
        }
    }

    private static byte[] AnyPart(Random random)
    {
        byte[] bytes = new byte[random.Next(0, 60)];
        for (int i = 0; i < bytes.Length; i++)
            bytes[i] = random.Next(3) == 0 ? new byte[] { 0xFF, 0xAA, 0xBB }[random.Next(3)] : (byte)random.Next(256);

        return random.Next(3) == 0 ? bytes : CommandScript.Packet(bytes, random.Next(1001, 1006));
    }

    // A plain search of the whole, byte by byte.
    private static (List<(int Id, byte[] Payload)> Replies, long Skipped) Search(byte[] bytes, int maxPayload)
    {
        var replies = new List<(int, byte[])>();
        long skipped = 0;
        int at = 0;
        while (at + 16 <= bytes.Length)
        {
            bool isHeader = bytes[at] == 0xFF && bytes[at + 1] == 0xAA && bytes[at + 14] == 0xFF && bytes[at + 15] == 0xBB;
            int size = isHeader ? BitConverter.ToInt32(bytes, at + 6) : 0;
            if (!isHeader)
            {
                at++;
                skipped++;
            }
            else if (size < 0 || size > maxPayload || at + 16 + size > bytes.Length)
            {
                return (replies, skipped);
            }
            else
            {
                replies.Add((BitConverter.ToUInt16(bytes, at + 4), bytes[(at + 16)..(at + 16 + size)]));
                at += 16 + size;
            }
        }

        // A remainder that starts with the first byte of a token may become a header.
        int first = Array.IndexOf(bytes, (byte)0xFF, at);
        return (replies, skipped + (first < 0 ? bytes.Length : first) - at);
    }

    private static (List<(int Id, byte[] Payload)> Replies, long Skipped) ReadAll(IEnumerable<ArraySegment<byte>> pieces, int maxPayload)
    {
        var reader = new CommandPacketReader(maxPayload);
        var replies = new List<(int, byte[])>();
        foreach (ArraySegment<byte> piece in pieces)
        {
            Add(reader, piece);
            while (reader.TryRead(out CommandChannelHeader header, out ReadOnlySpan<byte> payload))
            {
                if (!reader.IsAllowed(header))
                    return (replies, reader.Skipped);

                replies.Add((header.CommandId, payload.ToArray()));
            }
        }

        return (replies, reader.Skipped);
    }

    private static void Add(CommandPacketReader reader, ReadOnlySpan<byte> bytes)
    {
        while (bytes.Length > 0)
        {
            Span<byte> room = reader.GetRoom();
            int count = Math.Min(room.Length, bytes.Length);
            bytes[..count].CopyTo(room);
            reader.Add(count);
            bytes = bytes[count..];
        }
    }
}
