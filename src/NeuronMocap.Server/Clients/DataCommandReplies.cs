using System.Buffers.Binary;
using System.Text;
using NeuronMocap.Commands;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Clients;

/// <summary>
/// Replies of the broadcaster to commands on data connections (protocol.md section 7). All clients share it; thread-safe.
/// </summary>
internal sealed class DataCommandReplies(FramePlan plan, int? lengthField)
{
    private const int LengthOffset = 6;
    private const int BoneNameSize = 60;

    private readonly int[] _modes = [.. Enumerable.Repeat((int)CombinationMode.FullBody, plan.AvatarCount)];

    // Created on the first request. Two threads may create the same reply, and either one may be kept.
    private readonly byte[]?[] _boneSizes = new byte[]?[plan.AvatarCount];
    private readonly byte[]?[] _texts = new byte[]?[plan.AvatarCount];

    // The number of instances of a value. 0 if it is unknown how a reply carries the value.
    public int CountValues(DataCommandId id) => id switch
    {
        DataCommandId.AvatarCount => 1,
        DataCommandId.BoneSize or DataCommandId.DataFrequency or DataCommandId.BvhText or DataCommandId.CombinationMode => plan.AvatarCount,
        _ => 0,
    };

    // The number of avatars does not belong to an avatar, so the avatar of the request does not matter.
    public bool Has(DataCommandId id, int avatar) =>
        id == DataCommandId.AvatarCount || (uint)avatar < (uint)CountValues(id);

    public CombinationMode GetMode(int avatar) => (CombinationMode)Volatile.Read(ref _modes[avatar]);

    // Returns whether the value changed.
    public bool SetMode(int avatar, CombinationMode mode) => Interlocked.Exchange(ref _modes[avatar], (int)mode) != (int)mode;

    public int Measure(DataCommandId id, int avatar) => ProtocolConstants.HeaderSize + GetPayload(id, avatar).Length;

    // The destination has room for the measured size. The reply carries the current value.
    public void Write(DataCommandId id, int avatar, Span<byte> destination)
    {
        ReadOnlySpan<byte> payload = GetPayload(id, avatar);
        CreateHeader(id, avatar, payload.Length).Write(destination);
        if (lengthField is int length)
            BinaryPrimitives.WriteInt32LittleEndian(destination[LengthOffset..], length);

        payload.CopyTo(destination[ProtocolConstants.HeaderSize..]);
    }

    private DataCommandHeader CreateHeader(DataCommandId id, int avatar, int payloadSize)
    {
        var header = new DataCommandHeader { CommandId = id };
        return id switch
        {
            DataCommandId.BoneSize => header with { DataCount = BoneHierarchy.BoneCount },
            DataCommandId.BvhText => header with { DataCount = (uint)payloadSize },
            DataCommandId.AvatarCount => header with { Parameter = plan.AvatarCount },
            DataCommandId.CombinationMode => header with { Parameter = avatar, Value = (int)GetMode(avatar) },
            _ => header with { Parameter = avatar, Value = (int)Math.Round(plan.FrameRate) },
        };
    }

    private ReadOnlySpan<byte> GetPayload(DataCommandId id, int avatar) => id switch
    {
        DataCommandId.BoneSize => _boneSizes[avatar] ??= CreateBoneSizes(plan.Sources[avatar]),
        DataCommandId.BvhText => _texts[avatar] ??= Encoding.UTF8.GetBytes(SourceBody.GetHierarchy(plan.Sources[avatar], plan.Order, plan.Layout)),
        _ => default,
    };

    private static byte[] CreateBoneSizes(MotionSource source)
    {
        float[] lengths = SourceBody.GetLengths(source);
        byte[] entries = new byte[lengths.Length * DataCommandHeader.BoneSizeEntry];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Span<byte> entry = entries.AsSpan((int)bone * DataCommandHeader.BoneSizeEntry, DataCommandHeader.BoneSizeEntry);
            Encoding.UTF8.GetBytes(BoneHierarchy.GetName(bone, source.Variant), entry[..BoneNameSize]);
            BinaryPrimitives.WriteInt32LittleEndian(entry[BoneNameSize..], BitConverter.SingleToInt32Bits(lengths[(int)bone]));
        }

        return entries;
    }
}
