using System.Buffers.Binary;
using System.Text;
using NeuronMocap.Protocol;

namespace NeuronMocap.Commands;

/// <summary>
/// A packet that a server sent on the data connection, in reply to a command or after a registration (protocol.md section 7).
/// </summary>
/// <remarks>A reply owns its memory and never changes. A property is null if the reply is about another value.</remarks>
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

    /// <summary>The value that the reply is about. Servers can send numbers that the enumeration does not contain.</summary>
    public DataCommandId Id => Header.CommandId;

    /// <summary>The whole packet as received: a header of 64 bytes, followed by the payload.</summary>
    public ReadOnlyMemory<byte> Packet => _packet;

    /// <summary>The bytes after the header; empty for most commands.</summary>
    public ReadOnlyMemory<byte> Payload => _packet.AsMemory(ProtocolConstants.HeaderSize);

    /// <summary>
    /// The avatar, from 0, of a frame rate or a combination mode. It is not known whether other replies contain their avatar.
    /// </summary>
    public int? AvatarIndex => Id is DataCommandId.DataFrequency or DataCommandId.CombinationMode ? Header.Parameter : null;

    /// <summary>Number of avatars on the server.</summary>
    public int? AvatarCount => Id == DataCommandId.AvatarCount ? Header.Parameter : null;

    /// <summary>Frames per second of the avatar.</summary>
    public int? FrameRate => Id == DataCommandId.DataFrequency ? Header.Value : null;

    /// <summary>The set of sensors that the avatar wears. Servers can send numbers that the enumeration does not contain.</summary>
    public CombinationMode? CombinationMode => Id == DataCommandId.CombinationMode ? (CombinationMode)Header.Value : null;

    /// <summary>The avatar's hierarchy as the text of a BVH file.</summary>
    public string? BvhText => Id == DataCommandId.BvhText ? ReadText(Payload.Span) : null;

    /// <summary>Names and lengths of the avatar's bones, in the order of the server. Each call returns a new list.</summary>
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

    // Reads up to the first zero byte: names are padded with zeros, and a text may end with one.
    private static string ReadText(ReadOnlySpan<byte> bytes)
    {
        int end = bytes.IndexOf((byte)0);
        return Encoding.UTF8.GetString(end < 0 ? bytes : bytes[..end]);
    }
}
