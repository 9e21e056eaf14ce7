using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Gltf;

// The animation of one avatar: a track for the rotation of each bone, and one for its position. Positions are in metres.
internal sealed class PoseAnimation
{
    // In metres. Bones that only jitter by rounding do not need position keys.
    private const float SamePosition = 1e-6f;
    private const float Metre = 0.01f;

    private readonly KeyTrack[] _rotations = new KeyTrack[BoneHierarchy.BoneCount];
    private readonly KeyTrack[] _positions = new KeyTrack[BoneHierarchy.BoneCount];
    private readonly Quaternion[] _before = new Quaternion[BoneHierarchy.BoneCount];

    private readonly KeySpool _spool;

    public PoseAnimation(KeySpool spool, GlbOptions options)
    {
        _spool = spool;
        Times = new FloatList(spool);
        float angle = options.RotationTolerance * MathF.PI / 180;
        float distance = options.PositionTolerance / 1000;
        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            _rotations[bone] = new KeyTrack(spool, width: 4, angle > 0 ? new KeyReducer(angle, isRotation: true) : null, angle);
            float same = bone == 0 ? distance : Math.Max(distance, SamePosition);
            _positions[bone] = new KeyTrack(spool, width: 3, same > 0 ? new KeyReducer(same, isRotation: false) : null, same);
        }
    }

    // Of all frames.
    public FloatList Times { get; }

    public float FirstTime { get; private set; }

    public float LastTime { get; private set; }

    public KeyTrack GetRotation(int bone) => _rotations[bone];

    // Null if the bone stays where it is at rest.
    public KeyTrack? GetPosition(int bone, Vector3 offset)
    {
        KeyTrack track = _positions[bone];
        var rest = new Vector4(offset * Metre, 0);
        return bone > 0 && track.IsConstant && (track.First - rest).Length() <= SamePosition ? null : track;
    }

    // Returns false if the time does not advance in the seconds of the file, which are binary32.
    public bool Add(double seconds, ReadOnlySpan<BoneTransform> pose)
    {
        float time = (float)seconds;
        bool isFirst = Times.Count == 0;
        if (!isFirst && time <= LastTime)
            return false;

        _spool.RequireRoom();
        if (isFirst)
            FirstTime = time;

        LastTime = time;
        Times.Add(time);
        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            // Some programs interpolate the numbers of two quaternions without a look at their sides.
            Quaternion rotation = isFirst ? pose[bone].Rotation : QuaternionMath.InHemisphereOf(_before[bone], pose[bone].Rotation);
            _before[bone] = rotation;
            _rotations[bone].Add(time, new Vector4(rotation.X, rotation.Y, rotation.Z, rotation.W));
            _positions[bone].Add(time, new Vector4(pose[bone].Position * Metre, 0));
        }

        return true;
    }

    // After the last frame, once.
    public void Complete()
    {
        foreach (KeyTrack track in _rotations.Concat(_positions))
            track.Complete();
    }
}
