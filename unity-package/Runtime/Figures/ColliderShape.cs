#nullable enable

using NeuronMocap.Retargeting;

namespace NeuronMocap.Unity
{
    // The capsule of a bone. Lengths are shares of the length of the legs.
    internal sealed class ColliderShape
    {
        private ColliderShape(HumanoidBone bone, float radius, params HumanoidBone[] next)
        {
            Bone = bone;
            Radius = radius;
            Next = next;
        }

        public static ColliderShape[] All { get; } = CreateAll();

        public HumanoidBone Bone { get; }

        public float Radius { get; }

        // The bones at its end. The first that a figure has counts.
        public HumanoidBone[] Next { get; }

        // Without such a bone, the capsule has this length and continues the line from this bone, or else points forward.
        public float Length { get; private set; } = 0.2f;

        public HumanoidBone? Before { get; private set; }

        private static ColliderShape[] CreateAll()
        {
            var all = new ColliderShape[20];
            all[0] = new ColliderShape(HumanoidBone.Hips, 0.16f, HumanoidBone.Spine);
            all[1] = new ColliderShape(HumanoidBone.Spine, 0.15f, HumanoidBone.Chest, HumanoidBone.UpperChest, HumanoidBone.Neck, HumanoidBone.Head);
            all[2] = new ColliderShape(HumanoidBone.Chest, 0.16f, HumanoidBone.UpperChest, HumanoidBone.Neck, HumanoidBone.Head);
            all[3] = new ColliderShape(HumanoidBone.UpperChest, 0.16f, HumanoidBone.Neck, HumanoidBone.Head);
            all[4] = new ColliderShape(HumanoidBone.Neck, 0.06f, HumanoidBone.Head);
            all[5] = new ColliderShape(HumanoidBone.Head, 0.11f) { Before = HumanoidBone.Neck, Length = 0.25f };
            AddSide(all, 6, 0);
            AddSide(all, 13, 1);
            return all;
        }

        // Right bones follow their left ones.
        private static void AddSide(ColliderShape[] all, int first, int side)
        {
            all[first + 6] = Limb(HumanoidBone.LeftShoulder, 0.06f, HumanoidBone.LeftUpperArm, side);
            all[first] = Limb(HumanoidBone.LeftUpperArm, 0.055f, HumanoidBone.LeftLowerArm, side);
            all[first + 1] = Limb(HumanoidBone.LeftLowerArm, 0.045f, HumanoidBone.LeftHand, side);
            HumanoidBone finger = side == 0 ? HumanoidBone.LeftMiddleProximal : HumanoidBone.RightMiddleProximal;
            all[first + 2] = new ColliderShape(HumanoidBone.LeftHand + side, 0.045f, finger) { Before = HumanoidBone.LeftLowerArm + side, Length = 0.1f };
            all[first + 3] = Limb(HumanoidBone.LeftUpperLeg, 0.085f, HumanoidBone.LeftLowerLeg, side);
            all[first + 4] = Limb(HumanoidBone.LeftLowerLeg, 0.06f, HumanoidBone.LeftFoot, side);
            all[first + 5] = Limb(HumanoidBone.LeftFoot, 0.045f, HumanoidBone.LeftToes, side);
        }

        private static ColliderShape Limb(HumanoidBone bone, float radius, HumanoidBone next, int side) =>
            new ColliderShape(bone + side, radius, next + side);
    }
}
