using NeuronMocap.Commands;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>
/// The input as bytes of a command server. Reading it in pieces gives the same packets as a plain search of the whole. Payloads are answers or are
/// rejected.
/// </summary>
internal sealed class CommandsTarget
{
    private const int MaxPayload = 4_096;
    private const int Interpreted = 4;

    private static readonly int[] LargestPieces = [1, 40, 5_000];

    private readonly CommandReplies _replies = new("server");

    public void Run(FuzzInput input)
    {
        (int packets, long skipped, ulong digest) = Search(input.Bytes);
        foreach (int largest in LargestPieces)
        {
            (int Packets, long Skipped, ulong Digest) read = ReadPieces(input, largest);
            WrongResultException.ThrowUnless(
                read == (packets, skipped, digest),
                "In pieces of up to {0}, {1} packets come out, and not what the whole gives, {2}.",
                largest,
                read.Packets,
                packets);
        }

        input.Digest.Add(packets);
        input.Digest.Add(skipped);
        input.Found += packets;
        Interpret(input);
    }

    // Searches the whole byte by byte.
    private static (int Packets, long Skipped, ulong Digest) Search(ReadOnlySpan<byte> bytes)
    {
        Digest digest = default;
        int packets = 0;
        int at = 0;
        long skipped = 0;
        while (bytes.Length - at >= CommandChannelHeader.Size)
        {
            if (!CommandChannelHeader.TryRead(bytes[at..], out CommandChannelHeader header))
            {
                at++;
                skipped++;
                continue;
            }

            int end = at + CommandChannelHeader.Size + header.PayloadSize;
            if (header.PayloadSize is < 0 or > MaxPayload || end > bytes.Length)
                return (packets, skipped, digest.Value);

            digest.Add((long)header.CommandId);
            digest.Add(bytes[(end - header.PayloadSize)..end]);

            packets++;
            at = end;
        }

        int rest = bytes[at..].IndexOf((byte)0xFF);
        return (packets, skipped + (rest < 0 ? bytes.Length - at : rest), digest.Value);
    }

    private static (int Packets, long Skipped, ulong Digest) ReadPieces(FuzzInput input, int largest)
    {
        Digest digest = default;
        int packets = 0;
        var reader = new CommandPacketReader(MaxPayload);
        ReadOnlySpan<byte> rest = input.Bytes;
        while (!rest.IsEmpty)
        {
            Span<byte> room = reader.GetRoom();
            int size = Math.Min(Math.Min(rest.Length, room.Length), 1 + input.Random.Below(largest));
            rest[..size].CopyTo(room);
            reader.Add(size);
            rest = rest[size..];
            while (reader.TryRead(out CommandChannelHeader header, out ReadOnlySpan<byte> payload))
            {
                if (!reader.IsAllowed(header))
                    return (packets, reader.Skipped, digest.Value);

                digest.Add((long)header.CommandId);
                digest.Add(payload);

                packets++;
            }
        }

        return (packets, reader.Skipped, digest.Value);
    }

    private void Interpret(FuzzInput input)
    {
        var reader = new CommandPacketReader(MaxPayload);
        ReadOnlySpan<byte> rest = input.Bytes;
        for (int count = 0; !rest.IsEmpty && count < Interpreted;)
        {
            Span<byte> room = reader.GetRoom();
            int size = Math.Min(rest.Length, room.Length);
            rest[..size].CopyTo(room);
            reader.Add(size);
            rest = rest[size..];
            while (count < Interpreted && reader.TryRead(out CommandChannelHeader header, out ReadOnlySpan<byte> payload))
            {
                if (!reader.IsAllowed(header))
                    return;

                Interpret(payload, input);
                count++;
            }
        }
    }

    // Interprets the payload as the answer to each command, whatever its number.
    private void Interpret(ReadOnlySpan<byte> payload, FuzzInput input)
    {
        foreach (CommandChannelId id in (ReadOnlySpan<CommandChannelId>)
            [CommandChannelId.ZeroOut, CommandChannelId.RotationOrder, CommandChannelId.BoneDimensions, CommandChannelId.BvhHeader])
        {
            try
            {
                input.Digest.Add(Interpret(id, payload));
            }
            catch (NeuronCommandException refusal)
            {
                WrongResultException.ThrowUnless(
                    refusal.Reason is CommandFailure.InvalidReply or CommandFailure.Rejected, "A refusal has the reason {0}.", refusal.Reason);
                input.Digest.Add(refusal.Message);
            }
        }
    }

    private double Interpret(CommandChannelId id, ReadOnlySpan<byte> payload)
    {
        switch (id)
        {
            case CommandChannelId.ZeroOut:
                return _replies.ReadZeroOut(payload, avatar: 0) ? 1 : 0;
            case CommandChannelId.RotationOrder:
                RotationOrder order = _replies.ReadRotationOrder(payload);
                WrongResultException.ThrowUnless(Enum.IsDefined(order), "{0} is not an order.", order);
                return (int)order;
            case CommandChannelId.BoneDimensions:
                BoneDimensions sizes = _replies.ReadDimensions(payload, avatar: 0);
                WrongResultException.ThrowUnless(sizes.Head >= 0 && float.IsFinite(sizes.FootLength), "A size is none.");
                return sizes.Head;
            default:
                (string text, Bvh.BvhDocument document) = _replies.ReadHeader(payload, avatar: 0);
                WrongResultException.ThrowUnless(text.Length > 0 && document.Joints.Count > 0, "The header is empty.");
                return document.ChannelCount;
        }
    }
}
