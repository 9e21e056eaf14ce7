using System.Diagnostics;
using NeuronMocap.Benchmarks.Harness;
using NeuronMocap.Retargeting;
using NeuronMocap.Unity;
using UnityEngine;
using UnityEngine.StandIn;

namespace NeuronMocap.Benchmarks.Macro;

// The cost of a rendered frame of the Unity package in the tests' stand-in of the engine: one source, and a Humanoid of 72 transforms for each of its
// performers. Everything on the main thread counts: source, drivers, and the stand-in's own loop. Unity's transforms take another time.
internal static class UnityFrames
{
    private const string Cost = "ns/figure";
    private const int Parts = 200;
    private const int FramesPerPart = 20;

    private static readonly int[] Counts = [1, 20];

    private static readonly (string Name, Action<HumanoidDriver> Set)[] Options =
    [
        ("figures", static _ => { }),
        ("figures, plant feet", static driver => driver.FootPlanting = true),
        ("figures, displacement", static driver => driver.Displacement = true),
        ("figures, smoothing", static driver => driver.Smoothing = true),
        ("figures, every option", static driver =>
        {
            (driver.FootPlanting, driver.Displacement, driver.Smoothing, driver.Weight) = (true, true, true, 0.5f);
            (driver.RootMotionTarget, driver.WhenIdle) = (RootMotionTarget.RootTransform, IdleBehaviour.BlendToRest);
            SourceStage stage = driver.Source!.Stage;
            (stage.Offset, stage.Heading, stage.Mirror, stage.Scale) = (Vector3.one, 30, true, 1.2f);
        }),
    ];

    private static readonly Aim[] Aims = [new(Cost, 15_000, Way: "figures"), new(Cost, 25_000, Way: "figures, plant feet"), new("B/frame", 0)];

    public static async Task<int> RunAsync(int runs, Report report)
    {
        report.Begin($"Nanoseconds of a rendered frame for each performer, against a frame without figures. Median of {Parts} parts of {FramesPerPart} frames a run, {runs} runs.");
        foreach (int count in Counts)
        {
            using var loop = new PlayerLoop();
            MocapSource source = new GameObject("Source").AddComponent<MocapSource>();
            (source.Kind, source.PerformerCount) = (SourceKind.Simulator, count);
            HumanoidDriver[] drivers = [.. Enumerable.Range(0, count).Select(performer => AddFigure(source, performer))];
            loop.RunUntil(() => Array.TrueForAll(drivers, static driver => driver.IsDriving));

            Way[] ways = [.. Options.Select(option => new Way(option.Name, () => Measure(loop, drivers, option.Set)))];
            var empty = new Way("no figures", () => Measure(loop, drivers, static driver => driver.enabled = false));
            report.Add(await Alternation.RunAsync(count == 1 ? "1 performer" : $"{count} performers", runs, empty, ways, Aims));
        }

        return report.End();
    }

    private static Measurements Measure(PlayerLoop loop, HumanoidDriver[] drivers, Action<HumanoidDriver> set)
    {
        foreach (HumanoidDriver driver in drivers)
        {
            (driver.enabled, driver.FootPlanting, driver.Displacement, driver.Smoothing, driver.Weight) = (true, false, false, false, 1);
            (driver.RootMotionTarget, driver.WhenIdle) = (RootMotionTarget.Hips, IdleBehaviour.Hold);
            SourceStage stage = driver.Source!.Stage;
            (stage.Offset, stage.Heading, stage.Mirror, stage.Scale) = (Vector3.zero, 0, false, 1);
            set(driver);
        }

        loop.Frames(100);

        // Short parts, because one figure takes so little time that any other process would disturb a whole run.
        double[] nanoseconds = new double[Parts];
        long allocated = GC.GetAllocatedBytesForCurrentThread();
        for (int part = 0; part < Parts; part++)
        {
            long start = Stopwatch.GetTimestamp();
            loop.Frames(FramesPerPart);
            nanoseconds[part] = Stopwatch.GetElapsedTime(start).TotalNanoseconds / FramesPerPart;
        }

        allocated = GC.GetAllocatedBytesForCurrentThread() - allocated;
        return new Measurements { [Cost] = Spread.Of(nanoseconds).Median / drivers.Length, ["B/frame"] = allocated / (double)(Parts * FramesPerPart) };
    }

    private static HumanoidDriver AddFigure(MocapSource source, int performer)
    {
        TargetRig rig = RetargetCost.CreateRig(1, isTurned: false);
        var root = new GameObject($"Figure {performer}");
        var nodes = new Transform[rig.Nodes.Length];
        List<HumanBone> human = [];
        for (int i = 0; i < nodes.Length; i++)
        {
            RigNode node = rig.Nodes[i];
            nodes[i] = new GameObject($"{node.Name} {i}").transform;
            nodes[i].SetParent(node.Parent < 0 ? root.transform : nodes[node.Parent], worldPositionStays: false);
            (nodes[i].localPosition, nodes[i].localRotation) = (node.Position.ToUnity(), node.Rotation.ToUnity());
            if (rig.GetHumanoidBone(i) is { } bone)
                human.Add(new HumanBone { humanName = HumanoidBones.GetName(bone), boneName = nodes[i].name, limit = new HumanLimit { useDefaultValues = true } });
        }

        root.AddComponent<Animator>().avatar = AvatarBuilder.BuildHumanAvatar(root, Describe(human, [root.transform, .. nodes]));
        HumanoidDriver driver = root.AddComponent<HumanoidDriver>();
        (driver.Source, driver.PerformerIndex) = (source, performer);
        return driver;
    }

    private static HumanDescription Describe(List<HumanBone> human, Transform[] transforms) => new()
    {
        human = [.. human],
        skeleton = [.. transforms.Select(static item => new SkeletonBone { name = item.name, position = item.localPosition, rotation = item.localRotation, scale = item.localScale })],
        upperArmTwist = 0.5f,
        lowerArmTwist = 0.5f,
        upperLegTwist = 0.5f,
        lowerLegTwist = 0.5f,
        armStretch = 0.05f,
        legStretch = 0.05f,
    };
}
