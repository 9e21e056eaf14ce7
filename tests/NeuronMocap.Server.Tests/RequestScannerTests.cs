using NeuronMocap.Protocol;
using NeuronMocap.Server.Clients;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Server.Tests;

public sealed class RequestScannerTests
{
    [Fact]
    public void Requests_are_found_at_every_split()
    {
        byte[] stream = CreateStream();
        for (int split = 0; split <= stream.Length; split++)
        {
            var scanner = new RequestScanner();
            AssertRequests([.. Push(scanner, stream.AsMemory(0, split)), .. Push(scanner, stream.AsMemory(split))]);
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(63)]
    [InlineData(64)]
    [InlineData(65)]
    [InlineData(4096)]
    public void Requests_are_found_in_pieces_of_any_size(int size)
    {
        var scanner = new RequestScanner();
        AssertRequests([.. CreateStream().Chunk(size).SelectMany(piece => Push(scanner, piece))]);
    }

    // In a reply, a command's count would announce a payload.
    [Fact]
    public void A_request_has_no_payload_at_any_count()
    {
        var scanner = new RequestScanner();
        byte[] request = Requests.Create(0, 3, dataCount: 1_000_000);
        byte[] both = [.. request, .. request];
        Assert.Equal([0, 0], Push(scanner, both).Select(found => (int)found.CommandId));
    }

    // More than the scanner has room for, in one piece and without an end.
    [Fact]
    public void Noise_is_dropped_without_memory()
    {
        var scanner = new RequestScanner();
        byte[] noise = [.. Enumerable.Repeat((byte[])[0xFF, 0xAA, 0xFF, 0xBB, 0, 0, 0], 2000).SelectMany(bytes => bytes)];
        for (int i = 0; i < 50; i++)
            Assert.Empty(Push(scanner, noise));

        Assert.Single(Push(scanner, Requests.Create(5, 0)));
    }

    private static byte[] CreateStream() =>
    [
        0xFF, 0xAA, 0xFF, 1, 2, 3,
        .. Requests.Create(4, 1),
        .. Requests.Create(6, 2),
        .. Enumerable.Repeat((byte)0xFF, 70),
        .. Requests.Create(3, 3)[..40],
        .. Requests.Create(5, 4),
        0xFF,
    ];

    private static void AssertRequests(IReadOnlyList<DataCommandHeader> found) =>
        Assert.Equal([(4, 1), (6, 2), (5, 4)], found.Select(request => ((int)request.CommandId, request.Parameter)));

    private static List<DataCommandHeader> Push(RequestScanner scanner, ReadOnlyMemory<byte> bytes)
    {
        var found = new List<DataCommandHeader>();
        while (!bytes.IsEmpty)
        {
            int count = Math.Min(bytes.Length, scanner.Room.Length);
            bytes[..count].CopyTo(scanner.Room);
            bytes = bytes[count..];
            scanner.Advance(count);
            while (scanner.TryRead(out DataCommandHeader request))
                found.Add(request);
        }

        return found;
    }
}
