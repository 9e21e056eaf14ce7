using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Motion;

public sealed class PoseBufferThreadTests
{
    [Fact]
    public async Task Two_threads_never_see_half_a_frame()
    {
        // Every bone of a frame is at the frame's number. A torn or mixed pose has bones at different positions.
        const int Frames = 200_000;
        var buffer = new PoseBuffer(new PoseBufferOptions { Capacity = 16, Delay = TimeSpan.FromMilliseconds(20) });
        double time = 0;
        int pushed = 0;
        Task writer = Task.Run(
            () =>
            {
                BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
                for (int i = 0; i < Frames; i++)
                {
                    Array.Fill(pose, new BoneTransform(new Vector3(i), Quaternion.Identity));
                    if (buffer.Push(pose, i * 0.01, (uint)i))
                        pushed++;
                    Volatile.Write(ref time, i * 0.01);
                }
            },
            TestContext.Current.CancellationToken);

        BoneTransform[] seen = new BoneTransform[BoneHierarchy.BoneCount];
        int different = 0;
        bool isLast;
        do
        {
            isLast = writer.IsCompleted;
            if (buffer.Sample(Volatile.Read(ref time), seen) == PoseOrigin.None)
                continue;

            foreach (BoneTransform bone in seen)
            {
                if (bone.Position != seen[0].Position)
                    different++;
            }
        }
        while (!isLast);

        await writer.Soon();
        Assert.Equal(0, different);
        Assert.Equal(Frames, pushed + buffer.Dropped);
    }

    [Fact]
    public void Slot_numbers_wrap_around()
    {
        var ring = new PoseRing(8, int.MaxValue - 20);
        int taken = int.MaxValue - 20;
        for (int i = 0; i < 100; i++)
        {
            PoseSlot? slot = ring.Free;
            Assert.NotNull(slot);
            slot.Arrival = i;
            slot.IsDone = false;
            ring.Publish();
            Assert.Equal(unchecked(taken + 1), ring.End);
            Assert.Equal(i, ring.At(taken).Arrival);
            ring.At(taken).IsDone = true;
            taken = unchecked(taken + 1);
            ring.Release(taken);
        }
    }
}
