using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Commands;

// Parses the payloads of replies (protocol.md section 6). A payload that is not a valid answer causes an exception.
internal sealed class CommandReplies(string target)
{
    public bool ReadZeroOut(ReadOnlySpan<byte> payload, int? avatar)
    {
        // The vendor's library checks only the first byte, so 256 is a refusal.
        if (payload.IsEmpty || payload[0] == 0)
            throw CommandMessages.NotZeroedOut(target, avatar);

        return true;
    }

    public RotationOrder ReadRotationOrder(ReadOnlySpan<byte> payload)
    {
        if (payload.IsEmpty)
            throw CommandMessages.NoAnswer(target, avatar: null);

        // The value is an integer of four bytes; the vendor's library also accepts fewer.
        long value = 0;
        for (int i = Math.Min(payload.Length, sizeof(uint)) - 1; i >= 0; i--)
            value = (value << 8) | payload[i];

        if (value is < (int)RotationOrder.XZY or > (int)RotationOrder.ZYX)
            throw CommandMessages.InvalidReply(target, $"the rotation order is {value}; it must be 0 to 5.");

        return (RotationOrder)value;
    }

    public BoneDimensions ReadDimensions(ReadOnlySpan<byte> payload, int avatar)
    {
        if (payload.IsEmpty)
            throw CommandMessages.NoAnswer(target, avatar);
        if (payload.Length < BoneDimensions.Size)
            throw CommandMessages.InvalidReply(target, $"the bone sizes are {payload.Length} bytes instead of {BoneDimensions.Size}.");
        if (!BoneDimensions.TryRead(payload, out BoneDimensions dimensions))
            throw CommandMessages.InvalidReply(target, "the bone sizes are invalid: a size is negative, or is not a number.");

        return dimensions;
    }

    public (string Text, BvhDocument Document) ReadHeader(ReadOnlySpan<byte> payload, int avatar)
    {
        // C programs may include the terminator.
        ReadOnlySpan<byte> utf8 = payload;
        while (!utf8.IsEmpty && utf8[^1] == 0)
            utf8 = utf8[..^1];

        if (utf8.IsEmpty)
            throw CommandMessages.NoAnswer(target, avatar);

        try
        {
            BvhDocument document = BvhDocument.Parse(utf8);
            return document.ChannelCount > 0
                ? (Encoding.UTF8.GetString(utf8), document)
                : throw CommandMessages.InvalidReply(target, "the BVH header has no channels.");
        }
        catch (BvhFormatException exception)
        {
            throw CommandMessages.InvalidReply(target, $"the BVH header cannot be read: {exception.Message}", exception);
        }
    }
}
