#nullable enable

using System;
using NeuronMocap.Skeleton;
using Quaternion = System.Numerics.Quaternion;
using Vector3 = System.Numerics.Vector3;

namespace NeuronMocap.Unity
{
    // Brings poses of the stream to their place in the scene: mirrors them, moves the centre to the origin, and then scales, turns and moves the stage.
    // In the stream's axes and centimetres.
    internal readonly struct StagePlacement : IEquatable<StagePlacement>
    {
        private const int RightLeg = (int)Bone.RightUpLeg;
        private const int LeftLeg = (int)Bone.LeftUpLeg;
        private const int RightArm = (int)Bone.RightShoulder;
        private const int LeftArm = (int)Bone.LeftShoulder;

        private readonly StageCenter _center;
        private readonly Quaternion _heading;
        private readonly bool _isMirrored;
        private readonly float _scale;

        public StagePlacement(SourceStage stage, in StageCenter center)
        {
            UnityEngine.Vector3 offset = stage.Offset;
            bool isFinite = float.IsFinite(offset.x) && float.IsFinite(offset.y) && float.IsFinite(offset.z);
            Offset = isFinite ? offset.ToStreamPosition() : default;
            float heading = float.IsFinite(stage.Heading) ? stage.Heading : 0;
            _heading = heading == 0 ? Quaternion.Identity : UnityEngine.Quaternion.Euler(0, heading, 0).ToStreamRotation();
            _isMirrored = stage.Mirror;
            _scale = stage.Scale > 0 && float.IsFinite(stage.Scale) ? stage.Scale : 1;
            _center = _isMirrored ? center.Mirrored : center;
        }

        // Where the origin of the stage is.
        public Vector3 Offset { get; }

        // Whether bodies stay as they are.
        public bool KeepsBodies => !_isMirrored && _scale == 1;

        private bool IsNeutral => KeepsBodies && Offset == default && _heading.IsIdentity && _center.Equals(StageCenter.None);

        public static Vector3 Mirror(Vector3 position) => new Vector3(-position.X, position.Y, position.Z);

        public static Quaternion Mirror(Quaternion rotation) => new Quaternion(rotation.X, -rotation.Y, -rotation.Z, rotation.W);

        public bool ResizesLike(in StagePlacement other) => _isMirrored == other._isMirrored && _scale == other._scale;

        // pose: 59 transforms relative to the parent. Returns false if nothing changes.
        public bool TryApply(Span<BoneTransform> pose)
        {
            if (IsNeutral)
                return false;

            if (_isMirrored)
                MirrorPose(pose);

            for (int bone = 1; bone < pose.Length && _scale != 1; bone++)
                pose[bone] = new BoneTransform(pose[bone].Position * _scale, pose[bone].Rotation);

            Quaternion turn = _heading * Quaternion.Conjugate(_center.Turn);
            Vector3 position = Vector3.Transform((pose[0].Position - _center.Position) * _scale, turn) + Offset;
            pose[0] = new BoneTransform(position, turn * pose[0].Rotation);
            return true;
        }

        public SkeletonBody Apply(SkeletonBody body)
        {
            if (KeepsBodies)
                return body;

            Span<Vector3> offsets = stackalloc Vector3[BoneHierarchy.BoneCount];
            Span<Vector3> ends = stackalloc Vector3[BoneHierarchy.BoneCount];
            for (int bone = 0; bone < offsets.Length; bone++)
            {
                int other = _isMirrored ? Opposite(bone) : bone;
                offsets[bone] = Resize(body.Offsets[other]);
                ends[bone] = Resize(body.EndSites[other]);
            }

            return new SkeletonBody(offsets, ends, body.Variant);
        }

        public FootContacts Apply(FootContacts contacts) => _isMirrored ? new FootContacts(contacts.Right, contacts.Left) : contacts;

        public bool Equals(StagePlacement other) =>
            Offset == other.Offset && _heading == other._heading && ResizesLike(other) && _center.Equals(other._center);

        public override bool Equals(object? obj) => obj is StagePlacement other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(Offset, _heading, _isMirrored, _scale, _center);

        private static void MirrorPose(Span<BoneTransform> pose)
        {
            for (int bone = 0; bone < pose.Length; bone++)
            {
                int other = Opposite(bone);
                if (other > bone)
                    (pose[bone], pose[other]) = (pose[other], pose[bone]);
            }

            for (int bone = 0; bone < pose.Length; bone++)
                pose[bone] = new BoneTransform(Mirror(pose[bone].Position), Mirror(pose[bone].Rotation));
        }

        // The bone of the other side; of the spine, the bone itself.
        private static int Opposite(int bone) => bone switch
        {
            >= RightLeg and < LeftLeg => bone + LeftLeg - RightLeg,
            >= LeftLeg and < LeftLeg + LeftLeg - RightLeg => bone - LeftLeg + RightLeg,
            >= RightArm and < LeftArm => bone + LeftArm - RightArm,
            >= LeftArm => bone - LeftArm + RightArm,
            _ => bone,
        };

        private Vector3 Resize(Vector3 offset) => (_isMirrored ? Mirror(offset) : offset) * _scale;
    }
}
