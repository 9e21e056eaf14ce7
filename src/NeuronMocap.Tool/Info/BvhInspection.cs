using System.Numerics;
using System.Text.Json.Nodes;
using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Figures;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>The report of info about a BVH file.</summary>
internal sealed class BvhInspection(string path, IProgress<double> progress)
{
    public InfoReport Run(CancellationToken cancellationToken)
    {
        BvhDocument document = BvhFile.Load(path, progress, cancellationToken);
        bool isNeuron = BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out string? reason);
        long size = new FileInfo(path).Length;
        var report = new InfoReport(
            Path.GetFileName(path), "bvh", $"BVH file{(isNeuron ? " of Neuron's 59 bones" : string.Empty)}, {Quantity.Bytes(size)}");
        AddTake(report, document, size);
        AddSkeleton(report, document, map, reason);
        AddOddities(report, document, map, cancellationToken);
        if (map is not null && document.FrameCount > 0)
        {
            var source = new BvhSource(document);
            BodySection.Add(report, source);
            AddMotion(report, new BodyMotion(source), cancellationToken);
        }
        else if (document.FrameCount > 0)
        {
            AddMotion(report, new JointMotion(document), cancellationToken);
        }

        return report;
    }

    private void AddMotion(InfoReport report, PointMotion motion, CancellationToken cancellationToken) =>
        MotionSection.Add(report, motion, TakeCurves.Measure(motion, progress, cancellationToken));

    private static void AddTake(InfoReport report, BvhDocument document, long size)
    {
        InfoSection section = report.Section("take", "Take");
        double duration = document.FrameCount / document.FrameRate;
        section.Add("bytes", string.Empty, null, size);
        section.Add("seconds", "duration", Quantity.Format($"{duration:0.000} s"), duration);
        section.Add("frames", "frames", Quantity.Count(document.FrameCount), document.FrameCount);
        section.Add("frameRate", "frame rate", DescribeFrameRate(document), document.FrameRate);
        section.Add("declaredFrameTime", string.Empty, null, document.DeclaredFrameTime);
    }

    private static string DescribeFrameRate(BvhDocument document)
    {
        string rate = Quantity.Format($"{document.FrameRate:0.###} Hz");
        if (document.DeclaredFrameTime == 0)
            return rate + ", assumed: the file does not say";

        double declared = 1 / document.DeclaredFrameTime;
        return Math.Abs(declared - document.FrameRate) < document.FrameRate * 1e-6
            ? rate + Quantity.Format($": the file says {document.DeclaredFrameTime:0.#########} s")
            : rate + Quantity.Format($": the file says {document.DeclaredFrameTime:0.#########} s, which is {document.FrameTime.Numerator}/{document.FrameTime.Denominator} s rounded ({declared:0.##} Hz as stated)");
    }

    private static void AddSkeleton(InfoReport report, BvhDocument document, BvhSkeletonMap? map, string? reason)
    {
        InfoSection section = report.Section("skeleton", "Skeleton");
        int ends = document.Joints.Count(static joint => joint.EndSite is not null);
        int roots = document.Joints.Count(static joint => joint.Parent is null);
        section.Add(
            "joints",
            "joints",
            Quantity.Format($"{document.Joints.Count}, {Quantity.Count(ends, "End Site")}, {Depth(document)} deep, from {string.Join(" and ", document.Joints.Where(static joint => joint.Parent is null).Take(3).Select(static joint => joint.Name))}"),
            document.Joints.Count);
        section.Add("endSites", string.Empty, null, ends).Add("depth", string.Empty, null, Depth(document)).Add("roots", string.Empty, null, roots);
        section.Add("channels", "channels", Quantity.Format($"{document.ChannelCount} {Quantity.Noun(document.ChannelCount, "value")} a frame"), document.ChannelCount);
        if (map is null)
        {
            section.Add("notNeuron", "not Neuron's", reason!);
            section.Add("rotationOrders", "rotation order", Orders(document), new JsonArray([.. OrdersOf(document).Select(static order => (JsonNode)order.Order)]));
            section.Add(
                "jointNames",
                "first joints",
                BvhFile.NamesOf(document.Joints),
                new JsonArray([.. document.Joints.Select(static joint => (JsonNode)joint.Name)]));
            return;
        }

        bool isOld = map.Format.Variant == SkeletonVariant.Spine3;
        section.Add(
            "variant",
            "bone names",
            isOld ? "Spine3: Spine2, Spine3, Neck, Head, as before June 2018" : "Neck1: Spine2, Neck, Neck1, Head, as since June 2018",
            map.Format.Variant.ToString());
        section.Add("rotationOrder", "rotation order", map.Format.RotationOrder.ToString());
        section.Add("displacement", "displacement", map.Layout.HasDisplacement ? "on: a position for every bone" : "off: a position for the hips alone", map.Layout.HasDisplacement);
        section.Add("reference", "reference", map.Layout.HasReference ? "on: a Reference node is the parent of the hips" : "off", map.Layout.HasReference);
        var names = new JsonArray([.. map.OtherJoints.Select(static joint => (JsonNode)joint.Name)]);
        section.Add("otherJoints", "other joints", map.OtherJoints.Count > 0 ? $"{BvhFile.NamesOf(map.OtherJoints)}: only BVH files keep them" : null, names);
    }

    private static int Depth(BvhDocument document)
    {
        int[] depths = new int[document.Joints.Count];
        foreach (BvhJoint joint in document.Joints)
            depths[joint.Index] = joint.Parent is { } parent ? depths[parent.Index] + 1 : 1;

        return depths.Max();
    }

    private static IEnumerable<(string Order, int Joints)> OrdersOf(BvhDocument document) => document.Joints
        .Select(static joint => string.Concat(joint.Channels
            .Where(static channel => channel >= BvhChannel.Xrotation)
            .Select(static channel => (char)('X' + (channel - BvhChannel.Xrotation)))))
        .Where(static order => order.Length > 0)
        .GroupBy(static order => order, StringComparer.Ordinal)
        .Select(static group => (group.Key, group.Count()))
        .OrderByDescending(static order => order.Item2);

    private static string Orders(BvhDocument document)
    {
        (string Order, int Joints)[] orders = [.. OrdersOf(document)];
        return orders.Length switch
        {
            0 => "none: no joint rotates",
            1 => orders[0].Order,
            _ => string.Join(", ", orders.Select(static order => $"{order.Order} ({Quantity.Count(order.Joints, "joint")})")),
        };
    }

    private static void AddOddities(InfoReport report, BvhDocument document, BvhSkeletonMap? map, CancellationToken cancellationToken)
    {
        InfoSection section = report.Section("oddities", "Oddities");
        foreach (BvhRepair repair in document.Repairs)
            section.Remark("repair", repair.Description, repair.Line, repair.Column);
        if (document.RepairCount > document.Repairs.Count)
            section.Remark("repairs", $"{document.RepairCount - document.Repairs.Count} more {Quantity.Noun(document.RepairCount - document.Repairs.Count, "repair")}");
        if (document.FrameCount == 0)
        {
            section.Remark("noFrames", "a skeleton without frames");
            return;
        }

        RowScan scan = RowScan.Run(document.Joints, document.ChannelCount, document.FrameCount, document.GetValues, cancellationToken);
        RowWarnings.Add(section, scan, document.FrameRate, document.ChannelCount);
        if (map is { Layout.HasDisplacement: true })
            AddDisplacement(section, map);
        if (section.IsEmpty)
            section.Remark("none", "none");
    }

    private static void AddDisplacement(InfoSection section, BvhSkeletonMap map)
    {
        const float Least = 0.001f;
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        (float largest, Bone where, int frame) = (0, Bone.Hips, 0);
        for (int i = 0; i < map.Document.FrameCount; i++)
        {
            map.CopyLocalTransforms(i, pose);
            for (Bone bone = Bone.Hips + 1; (int)bone < BoneHierarchy.BoneCount; bone++)
            {
                float distance = Vector3.Distance(pose[(int)bone].Position, map[bone].Offset);
                if (distance > largest)
                    (largest, where, frame) = (distance, bone, i);
            }
        }

        if (largest >= Least)
        {
            section.Remark(
                "displacement",
                Quantity.Format($"positions differ from the OFFSETs, by {largest:0.00} cm at most ({map[where].Name} at {frame / map.Document.FrameRate:0.00} s): the skeleton changes its size"));
        }
    }
}
