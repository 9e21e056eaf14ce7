using System.Numerics;
using System.Runtime.InteropServices;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Server;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Server.Tests.Sources;

public sealed class StudioCalculationSynthesizerTests
{
    private const int BoneSize = 84;

    [Fact]
    public void Sensors_follow_the_order_of_the_calculation_stream()
    {
        var actor = new SyntheticSource(60, 1);
        for (long frame = 0; frame < 2400; frame += 171)
        {
            float[] calculation = new float[946];
            CalculationSynthesizer.Write(actor, frame, calculation);
            byte[] payload = Calculate(actor, frame);
            for (int index = 0; index < 59; index++)
            {
                float[] sensor = calculation[((index * 16) + (index < 21 ? 0 : 2))..];
                float[] bone = GetValues(payload, CalculationOrder.Bones[index]);
                Assert.Equal([sensor[7], sensor[8], sensor[9], sensor[6]], bone[..4]);
                Assert.Equal(sensor[13..16], bone[4..7]);
                Assert.Equal(sensor[10..13], bone[7..10]);
            }
        }
    }

    [Fact]
    public void Positions_and_rotations_are_the_world_transforms_of_joints()
    {
        var actor = new SyntheticSource(60);
        BoneTransform[] world = ActorMeasures.GetWorld(actor, 500);
        byte[] payload = Calculate(actor, 500);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            float[] values = GetValues(payload, bone);
            Vector3 position = world[(int)bone].Position / 100;
            Assert.True(Vector3.Distance(position, new Vector3(values[13], values[14], values[15])) < 1e-5f);
            Assert.True(ActorMeasures.Degrees(world[(int)bone].Rotation, new Quaternion(values[16], values[17], values[18], values[19])) < 1e-3);
            Assert.Equal(0, BitConverter.ToInt32(payload, ((int)bone * BoneSize) + 80));
        }
    }

    [Fact]
    public void Velocities_sum_up_to_the_path()
    {
        var actor = new SyntheticSource(60);
        float[][] hand = [.. Enumerable.Range(0, 301).Select(frame => GetValues(Calculate(actor, frame), Bone.RightHand))];
        Vector3 way = Vector3.Zero;
        for (int i = 1; i < hand.Length; i++)
            way += (new Vector3(hand[i - 1].AsSpan(10, 3)) + new Vector3(hand[i].AsSpan(10, 3))) / 120;

        Assert.True(Vector3.Distance(new Vector3(hand[^1].AsSpan(13, 3)) - new Vector3(hand[0].AsSpan(13, 3)), way) < 0.005f);
    }

    [Fact]
    public void Values_exist_up_to_the_ends_of_a_take()
    {
        var take = new TestSource(1, frameCount: 2);
        Assert.All(new[] { 0, 1 }, frame => Assert.Equal([0, 0, 0], GetValues(Calculate(take, frame), Bone.Head)[10..13]));
        Assert.Throws<ArgumentOutOfRangeException>(() => Calculate(take, 2));
        Assert.Throws<ArgumentException>(() => StudioCalculationSynthesizer.Write(take, 0, new byte[4955]));
    }

    [Fact]
    public void Writing_allocates_nothing()
    {
        var actor = new SyntheticSource(60);
        byte[] payload = new byte[4956];
        Allocations.AssertNone(() => StudioCalculationSynthesizer.Write(actor, 7, payload));
    }

    private static byte[] Calculate(MotionSource source, long frame)
    {
        byte[] payload = new byte[4956];
        payload.AsSpan().Fill(0xCC);
        StudioCalculationSynthesizer.Write(source, frame, payload);
        return payload;
    }

    private static float[] GetValues(byte[] payload, Bone bone) =>
        MemoryMarshal.Cast<byte, float>(payload.AsSpan((int)bone * BoneSize, 80)).ToArray();
}
