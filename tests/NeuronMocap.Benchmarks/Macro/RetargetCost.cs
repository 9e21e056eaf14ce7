using System.Numerics;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Retargeting;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Benchmarks.Macro;

// The cost of one frame of one actor on a Humanoid character with all bones, twist bones and turned rest rotations.
internal static class RetargetCost
{
    private const int Frames = 64;
    private const double Interval = 1 / 120.0;

    public static async Task<int> RunAsync(int runs, Report report)
    {
        report.Begin($"Nanoseconds a frame and character, against copying the pose's 59 transforms once; {HotLoop.Rounds} frames a run, {runs} runs.");
        var take = new Take();
        var plain = new Character(CreateRig(1), new RetargetOptions());
        var weighted = new Character(CreateRig(1), Half());
        var displaced = new Character(CreateRig(1), new RetargetOptions { Displacement = true });
        var sheared = new Character(CreateRig(1.1f), new RetargetOptions());
        Way[] ways =
        [
            new("retarget", () => HotLoop.Measure(i => plain.Retarget(take[i]))),
            new("retarget, all weights one half", () => HotLoop.Measure(i => weighted.Retarget(take[i]))),
            new("retarget, displacement", () => HotLoop.Measure(i => displaced.Retarget(take[i]))),
            new("places of all nodes", () => HotLoop.Measure(_ => plain.Result.UpdateWorld())),
            new("places of all nodes, sheared", () => HotLoop.Measure(_ => sheared.Result.UpdateWorld())),
            new("retarget, plant feet", () => HotLoop.Measure(i => plain.RetargetAndPlant(take[i], take.ContactsAt(i)))),
            new("retarget, plant feet, sheared", () => HotLoop.Measure(i => sheared.RetargetAndPlant(take[i], take.ContactsAt(i)))),
        ];
        Aim[] aims = [new("ns/frame", 15_000), new("B/frame", 0)];
        report.Add(await Alternation.RunAsync("one frame", runs, new Way("copy", () => HotLoop.Measure(take.Copy)), ways, aims));
        return report.End();
    }

    private static RetargetOptions Half()
    {
        var options = new RetargetOptions();
        options.Weights.SetPart(BodyParts.All, 0.5f);
        return options;
    }

    // As tall as the default body, with a twist node between every two bones of arms and legs, as many characters have.
    internal static TargetRig CreateRig(float armatureHeight, bool isTurned = true)
    {
        var random = new Random(1);
        List<RigNode> nodes = [new("Armature", -1, Vector3.Zero, Quaternion.Identity, new Vector3(1, armatureHeight, 1))];
        int[] nodeByBone = new int[HumanoidBones.Count];
        Add(HumanoidBone.Hips, 0);
        return TargetRig.CreateHumanoid([.. nodes], nodeByBone, Quaternion.Identity);

        void Add(HumanoidBone bone, int parent)
        {
            Vector3 way = WayTo(bone);
            bool hasTwist = (HumanoidBones.GetPart(bone) & (BodyParts.Arms | BodyParts.Legs)) != BodyParts.None;
            if (hasTwist)
            {
                nodes.Add(new RigNode("Twist", parent, way / 2, Quaternion.Identity));
                parent = nodes.Count - 1;
                way /= 2;
            }

            // Turned bones move the joints out of the T-pose. That matters to this measurement only in the legs.
            bool turns = isTurned && HumanoidBones.GetPart(bone) is not (BodyParts.Hips or BodyParts.LeftLeg or BodyParts.RightLeg);
            Quaternion rotation = turns ? Quaternion.CreateFromYawPitchRoll(random.NextSingle(), random.NextSingle(), random.NextSingle()) : Quaternion.Identity;
            nodes.Add(new RigNode(bone.ToString(), parent, way, rotation));
            int node = nodeByBone[(int)bone] = nodes.Count - 1;
            for (int child = 0; child < HumanoidBones.Count; child++)
            {
                if (HumanoidBones.GetParent((HumanoidBone)child) == bone)
                    Add((HumanoidBone)child, node);
            }
        }
    }

    private static Vector3 WayTo(HumanoidBone bone) => bone is HumanoidBone.LeftToes or HumanoidBone.RightToes
        ? new Vector3(0, -0.08f, 0.12f)
        : HumanoidMap.GetBone(bone, SkeletonVariant.Neck1, HumanoidBoneSet.All) is { } source
            ? UnityAxes.ToUnityPosition(DefaultOffsets.Get(source))
            : new Vector3(0, 0.05f, 0.05f);

    private sealed class Take
    {
        private readonly BoneTransform[][] _poses = new BoneTransform[Frames][];
        private readonly FootContacts[] _contacts = new FootContacts[Frames];
        private readonly BoneTransform[] _copy = new BoneTransform[BoneHierarchy.BoneCount];

        public Take()
        {
            var actor = new SyntheticSource(1 / Interval);
            for (int i = 0; i < Frames; i++)
            {
                _poses[i] = new BoneTransform[BoneHierarchy.BoneCount];
                actor.GetPose(i, _poses[i]);
                (bool left, bool right) = actor.GetFootContacts(i);
                _contacts[i] = new FootContacts(left, right);
            }
        }

        public BoneTransform[] this[int i] => _poses[i % Frames];

        public FootContacts ContactsAt(int i) => _contacts[i % Frames];

        public void Copy(int i) => this[i].AsSpan().CopyTo(_copy);
    }

    private sealed class Character(TargetRig rig, RetargetOptions options)
    {
        private readonly Retargeter _retargeter = new(rig, SkeletonBody.GetDefault(), options);
        private readonly FootPlanter _planter = new(rig);
        private double _seconds;

        public RetargetedPose Result { get; } = new(rig);

        public void Retarget(BoneTransform[] pose)
        {
            if (!_retargeter.TryRetarget(pose, Result))
                throw new InvalidOperationException("The pose was rejected.");
        }

        public void RetargetAndPlant(BoneTransform[] pose, FootContacts contacts)
        {
            Retarget(pose);
            _planter.Plant(Result, contacts, _seconds += Interval);
        }
    }
}
