using NeuronMocap.Commands;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;
using NeuronMocap.Server;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Clients;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>
/// The input as bytes that a client sends to a broadcast. Reading it in pieces gives the same requests as a plain search of the whole. Each answer is
/// a packet.
/// </summary>
internal sealed class RequestsTarget
{
    private const int LongestAnswer = 64 * 1024;

    private static readonly int[] LargestPieces = [1, 70, 5_000];

    private readonly byte[] _answer = new byte[LongestAnswer];

    private readonly DataCommandReplies _replies = new(
        new FramePlan(new BroadcasterOptions { Sources = [new SyntheticSource(), new SyntheticSource()] }, [new AvatarName("Char00"), new AvatarName("Char01")], 60, hasMotion: true, hasCalculation: false), lengthField: null);

    public void Run(FuzzInput input)
    {
        ulong expected = Search(input);
        input.Digest.Add(expected);
        foreach (int largest in LargestPieces)
            WrongResultException.ThrowUnless(ReadPieces(input, largest) == expected, "In pieces of up to {0} other requests come out.", largest);

        Answer(input);
    }

    private static ulong Search(FuzzInput input)
    {
        Digest digest = default;
        ReadOnlySpan<byte> bytes = input.Bytes;
        for (int at = 0; bytes.Length - at >= ProtocolConstants.HeaderSize; at++)
        {
            if (!DataCommandHeader.TryRead(bytes[at..], out DataCommandHeader request))
                continue;

            HeadersTarget.AddFields(ref digest, request);
            at += ProtocolConstants.HeaderSize - 1;
            input.Found++;
        }

        return digest.Value;
    }

    private static ulong ReadPieces(FuzzInput input, int largest)
    {
        Digest digest = default;
        var scanner = new RequestScanner();
        ReadOnlySpan<byte> rest = input.Bytes;
        while (!rest.IsEmpty)
        {
            Push(scanner, ref rest, 1 + input.Random.Below(largest));
            while (scanner.TryRead(out DataCommandHeader request))
                HeadersTarget.AddFields(ref digest, request);
        }

        return digest.Value;
    }

    private static void Push(RequestScanner scanner, ref ReadOnlySpan<byte> rest, int most)
    {
        int size = Math.Min(Math.Min(rest.Length, scanner.Room.Length), most);
        WrongResultException.ThrowUnless(size > 0, "There is no room for another byte.");
        rest[..size].CopyTo(scanner.Room.Span);
        scanner.Advance(size);
        rest = rest[size..];
    }

    private void Answer(FuzzInput input)
    {
        var queue = new DataCommandQueue(_replies);
        var scanner = new RequestScanner();
        ReadOnlySpan<byte> rest = input.Bytes;
        while (!rest.IsEmpty)
        {
            Push(scanner, ref rest, int.MaxValue);
            while (scanner.TryRead(out DataCommandHeader request))
                queue.Accept(request);
        }

        while (queue.TryTake(out DataCommandId id, out int avatar))
        {
            int length = _replies.Measure(id, avatar);
            _replies.Write(id, avatar, _answer.AsSpan(0, length));
            var reply = new DataCommandReply(_answer.AsSpan(0, length));
            WrongResultException.ThrowUnless(reply.Id == id, "An answer is to another request.");
            input.Digest.Add((long)id);
            input.Digest.Add((long)avatar);
        }
    }
}
