using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>Decodes the input, parts of it, and its values behind a valid header, as compact poses. A decoded pose is finite, and is the same when it is encoded and decoded again.</summary>
internal sealed class CompactPoseTarget
{
    private const int ValuesOffset = 20;

    private readonly BoneTransform[] _pose = new BoneTransform[BoneHierarchy.BoneCount];
    private readonly BoneTransform[] _again = new BoneTransform[BoneHierarchy.BoneCount];
    private readonly byte[] _bytes = new byte[CompactPose.MaxSize];
    private readonly byte[] _mended = new byte[CompactPose.MaxSize];

    public void Run(FuzzInput input)
    {
        Read(input, input.Bytes);
        int start = input.Random.Below(input.Bytes.Length + 1);
        Read(input, input.Bytes[start..]);
        Read(input, input.Bytes[..start]);
        ReadMended(input);
    }

    // Most changed headers are refused, whatever follows.
    private void ReadMended(FuzzInput input)
    {
        SkeletonBody.GetDefault().CopyRestPose(_pose);
        CompactPose.TryEncode(default, _pose, _mended, out int size);
        if (input.Bytes.Length <= ValuesOffset)
            return;

        ReadOnlySpan<byte> values = input.Bytes[ValuesOffset..];
        values[..Math.Min(values.Length, size - ValuesOffset)].CopyTo(_mended.AsSpan(ValuesOffset));
        Read(input, _mended.AsSpan(0, size));
    }

    private void Read(FuzzInput input, ReadOnlySpan<byte> bytes)
    {
        if (!CompactPose.TryDecode(bytes, out CompactPoseHeader header, _pose))
            return;

        input.Found++;
        input.Digest.Add((long)header.AvatarIndex);
        input.Digest.Add(header.FrameIndex ?? -1L);
        input.Digest.Add(header.Time.UtcTicks);
        input.Digest.Add(_pose[0].Position.Length());
        bool isEncoded = CompactPose.TryEncode(header, _pose, _bytes, out int size);
        WrongResultException.ThrowUnless(
            isEncoded && CompactPose.TryDecode(_bytes.AsSpan(0, size), out CompactPoseHeader again, _again) && again == header,
            "A pose of {0} bytes has another header when it is encoded again.",
            bytes.Length);
        for (int bone = 0; bone < _pose.Length; bone++)
        {
            input.Digest.Add(_pose[bone].Rotation.W);
            float cosine = Math.Abs(System.Numerics.Quaternion.Dot(_pose[bone].Rotation, _again[bone].Rotation));
            WrongResultException.ThrowUnless(cosine > 0.99999f && cosine < 1.00001f, "Bone {0} turns by {1} when it is encoded again.", bone, cosine);
        }
    }
}
