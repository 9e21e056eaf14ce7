using NeuronMocap.Commands;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>Reads every command packet of the input as a reply on the data connection, and queries everything about it.</summary>
internal sealed class RepliesTarget
{
    private readonly PacketScanner _scanner = new();

    public void Run(FuzzInput input)
    {
        ReadOnlySpan<byte> rest = input.Bytes;
        while (_scanner.Scan(rest) is { Status: not ScanStatus.NeedMoreData } result)
        {
            if (result is { Status: ScanStatus.Packet, Kind: PacketKind.Command })
                Read(rest[..result.Length], input);

            rest = rest[result.Length..];
        }
    }

    private static void Read(ReadOnlySpan<byte> packet, FuzzInput input)
    {
        var reply = new DataCommandReply(packet);
        WrongResultException.ThrowUnless(reply.Packet.Span.SequenceEqual(packet), "A reply holds other bytes than its packet.");
        input.Found++;
        input.Digest.Add((long)reply.Id);
        input.Digest.Add((reply.AvatarIndex ?? -1L) + (reply.AvatarCount ?? 0) + (reply.FrameRate ?? 0) + (long)reply.CombinationMode.GetValueOrDefault());
        input.Digest.Add(reply.BvhText);
        foreach (BoneSize bone in reply.BoneSizes ?? [])
        {
            input.Digest.Add(bone.Name);
            input.Digest.Add(bone.Length);
        }
    }
}
