using NeuronMocap.Skeleton;
using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.DebugViews;

public sealed class SkeletonLabelTests : IDisposable
{
    private const string Label = "Label ";

    private readonly PlayerLoop _loop = new() { DrawsGizmos = true };

    public void Dispose() => _loop.Dispose();

    [Theory]
    [InlineData(SkeletonVariant.Neck1, "Spine3")]
    [InlineData(SkeletonVariant.Spine3, "Neck1")]
    public void Joints_are_labelled_except_fingers(SkeletonVariant variant, string other)
    {
        using NeuronMocap.Server.Broadcaster server = Stage.Broadcast(new StandingActor(SkeletonBody.GetDefault(variant)));
        MocapSource source = Stage.AddClient(server);
        source.SkeletonVariant = variant == SkeletonVariant.Neck1 ? SkeletonVariantSetting.Neck1 : SkeletonVariantSetting.Spine3;
        var view = new GameObject("View").AddComponent<SkeletonView>();
        view.transform.SetPositionAndRotation(new Vector3(1, 0, 2), Quaternion.Euler(0, 45, 0));
        (view.Source, view.ShowBones, view.ShowJoints, view.ShowContacts) = (source, false, false, false);
        _loop.RunUntil(() => Stage.IsLive(source));
        _loop.Frame();
        Assert.Empty(GizmoLog.Calls);

        view.ShowNames = true;
        _loop.Frame();

        Performer performer = source.Performers[0];
        Assert.Equal(variant, performer.Variant);
        Bone[] named = [.. BoneHierarchy.Bones.ToArray().Where(static bone => bone is <= Bone.RightHand or (>= Bone.LeftShoulder and <= Bone.LeftHand))];
        Assert.Equal(named.Select(bone => Label + BoneHierarchy.GetName(bone, variant)), GizmoLog.Calls.Select(static call => call.Shape));
        Assert.DoesNotContain(GizmoLog.Calls, call => call.Shape == Label + other);
        foreach ((GizmoCall call, Bone bone) in GizmoLog.Calls.Zip(named))
            Assert.True((call.From - view.transform.TransformPoint(performer.GetPosition(bone))).magnitude < 1e-4f, $"{bone}");

        Assert.Equal(Matrix4x4.identity, UnityEditor.Handles.matrix);
    }
}
