using System.Buffers.Binary;
using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Commands;

/// <summary>
/// What a server sent on the data connection in answer to a command, or by itself after a registration (protocol.md section 7). It owns its
/// memory and never changes. The members for a value are null where the reply is about something else.
/// </summary>
public sealed class DataCommandReply
{
    private const int BoneNameSize = 60;

    private readonly byte[] _packet;

    /// <summary>Reads a reply.</summary>
    /// <param name="packet">The 64 bytes of the header and the payload; copied.</param>
    /// <exception cref="ArgumentException">The bytes are not one whole command packet.</exception>
    public DataCommandReply(ReadOnlySpan<byte> packet)
    {
        if (!DataCommandHeader.TryRead(packet, out DataCommandHeader header) || packet.Length != ProtocolConstants.HeaderSize + header.PayloadSize)
            throw new ArgumentException("The bytes are not exactly one command packet.", nameof(packet));

        _packet = packet.ToArray();
        Header = header;
    }

    /// <summary>The fields of the header.</summary>
    public DataCommandHeader Header { get; }

    /// <summary>What the reply is about. Servers may send numbers that the enumeration lacks.</summary>
    public DataCommandId Id => Header.CommandId;

    /// <summary>The whole packet as received: 64 bytes of header, then the payload.</summary>
    public ReadOnlyMemory<byte> Packet => _packet;

    /// <summary>The bytes behind the header; none for most commands.</summary>
    public ReadOnlyMemory<byte> Payload => _packet.AsMemory(ProtocolConstants.HeaderSize);

    /// <summary>
    /// The avatar, from 0, that a frequency or a combination mode belongs to. Whether other replies name their avatar is not known.
    /// </summary>
    public int? AvatarIndex => Id is DataCommandId.DataFrequency or DataCommandId.CombinationMode ? Header.Parameter : null;

    /// <summary>Number of avatars on the server.</summary>
    public int? AvatarCount => Id == DataCommandId.AvatarCount ? Header.Parameter : null;

    /// <summary>Frames per second of the avatar.</summary>
    public int? Frequency => Id == DataCommandId.DataFrequency ? Header.Value : null;

    /// <summary>Which sensors the avatar wears. Servers may send numbers that the enumeration lacks.</summary>
    public SensorCombination? CombinationMode => Id == DataCommandId.CombinationMode ? (SensorCombination)Header.Value : null;

    /// <summary>The avatar's hierarchy as the text of a BVH file.</summary>
    public string? BvhText => Id == DataCommandId.BvhText ? ReadText(Payload.Span) : null;

    /// <summary>Names and lengths of the avatar's bones, in the order of the server. A new list on every call.</summary>
    public IReadOnlyList<BoneSize>? BoneSizes => Id == DataCommandId.BoneSize ? ReadBoneSizes() : null;

    private BoneSize[] ReadBoneSizes()
    {
        var sizes = new BoneSize[Payload.Length / DataCommandHeader.BoneSizeEntry];
        for (int i = 0; i < sizes.Length; i++)
        {
            ReadOnlySpan<byte> entry = Payload.Span.Slice(i * DataCommandHeader.BoneSizeEntry, DataCommandHeader.BoneSizeEntry);
            float length = BitConverter.Int32BitsToSingle(BinaryPrimitives.ReadInt32LittleEndian(entry[BoneNameSize..]));
            sizes[i] = new BoneSize(ReadText(entry[..BoneNameSize]), length);
        }

        return sizes;
    }

    // Up to the first zero byte: names are padded with them, and a text may have one at its end.
    private static string ReadText(ReadOnlySpan<byte> bytes)
    {
        int end = bytes.IndexOf((byte)0);
        return Encoding.UTF8.GetString(end < 0 ? bytes : bytes[..end]);
    }
}
