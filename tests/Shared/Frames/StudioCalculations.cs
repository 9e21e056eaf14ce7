using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Frames;

// The fixture studio-calculation: field f of bone b is b + f/32, and bone 4 has lost its sensor.
internal static class StudioCalculations
{
    public static void AssertFixture(StudioCalculationFrame frame)
    {
        Assert.True(frame.HasSkeleton);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Assert.Equal(new Quaternion(Field(bone, 0), Field(bone, 1), Field(bone, 2), Field(bone, 3)), frame.GetSensorRotation(bone));
            Assert.Equal(Vector(bone, 4), frame.GetAngularVelocity(bone));
            Assert.Equal(Vector(bone, 7), frame.GetAcceleration(bone));
            Assert.Equal(Vector(bone, 10), frame.GetVelocity(bone));
            Assert.Equal(Vector(bone, 13), frame.GetPosition(bone));
            Assert.Equal(new Quaternion(Field(bone, 16), Field(bone, 17), Field(bone, 18), Field(bone, 19)), frame.GetBoneRotation(bone));
            Assert.Equal((int)bone == 4, frame.IsSensorLost(bone));
        }
    }

    private static float Field(Bone bone, int field) => (int)bone + (field / 32f);

    private static Vector3 Vector(Bone bone, int field) => new(Field(bone, field), Field(bone, field + 1), Field(bone, field + 2));
}
