#nullable enable

using System;
using Quaternion = System.Numerics.Quaternion;
using Vector3 = System.Numerics.Vector3;

namespace NeuronMocap.Unity
{
    // The place on the floor, and the facing, that become origin and forward of the stage. In the stream's axes and centimetres.
    internal readonly struct StageCenter : IEquatable<StageCenter>
    {
        public StageCenter(BoneTransform hips)
        {
            Position = new Vector3(hips.Position.X, 0, hips.Position.Z);
            Turn = Heading.About(Vector3.UnitY, hips.Rotation);
        }

        private StageCenter(Vector3 position, Quaternion turn)
        {
            Position = position;
            Turn = turn;
        }

        public static StageCenter None => new StageCenter(default, Quaternion.Identity);

        public Vector3 Position { get; }

        public Quaternion Turn { get; }

        public StageCenter Mirrored => new StageCenter(StagePlacement.Mirror(Position), StagePlacement.Mirror(Turn));

        public bool Equals(StageCenter other) => Position == other.Position && Turn == other.Turn;

        public override bool Equals(object? obj) => obj is StageCenter other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(Position, Turn);
    }
}
