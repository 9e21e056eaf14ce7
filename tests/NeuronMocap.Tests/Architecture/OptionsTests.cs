using System.Reflection;
using NeuronMocap.Bvh;
using NeuronMocap.Calculation;
using NeuronMocap.Motion;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Architecture;

// One convention for all options: sealed classes with setters, copied on use. RetargetOptions and FootPlanterOptions are not copied: an application changes
// them between frames.
public sealed class OptionsTests
{
    public static TheoryData<Type> Options =>
        [.. new[] { typeof(NeuronReader), typeof(Broadcaster) }.SelectMany(static type => type.Assembly.GetExportedTypes()).Where(static type => type.Name.EndsWith("Options", StringComparison.Ordinal))];

    [Theory]
    [MemberData(nameof(Options))]
    public void Options_are_sealed_classes_with_setters(Type type)
    {
        Assert.True(type is { IsClass: true, IsSealed: true });
        Assert.DoesNotContain(type.GetMethods(), static method => method.Name is "<Clone>$");
        Assert.NotNull(type.GetConstructor(Type.EmptyTypes));
        Assert.All(type.GetProperties(), static property =>
        {
            MethodInfo setter = Assert.IsAssignableFrom<MethodInfo>(property.SetMethod);
            Assert.True(setter.IsPublic);
            Assert.Empty(setter.ReturnParameter.GetRequiredCustomModifiers());
        });
    }

    [Fact]
    public void Changing_options_after_use_has_no_effect()
    {
        var take = new BvhTakeOptions { FrameTime = new BvhFrameTime(1, 60) };
        using var file = new MemoryStream();
        using (var writer = new BvhTakeWriter(file, take))
        {
            take.FrameTime = new BvhFrameTime(1, 96);
            Assert.Equal(60, writer.FrameTime.FrameRate);
        }

        var calculation = new CalculationReadOptions { FrameRate = 60 };
        using var reader = new CalculationFileReader(new MemoryStream(CalculationRow()), calculation);
        calculation.FrameRate = 96;
        Assert.Equal(60, reader.FrameRate);

        var smooth = new PoseBufferOptions { Interpolation = PoseInterpolationMethod.Linear, MaxExtrapolation = TimeSpan.Zero, Delay = TimeSpan.Zero };
        var buffer = new PoseBuffer(smooth);
        smooth.MaxExtrapolation = TimeSpan.FromSeconds(1);
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        for (int i = 0; i < 10; i++)
        {
            pose[0] = new BoneTransform(new(i, 0, 0), System.Numerics.Quaternion.Identity);
            buffer.Push(pose, i / 60.0);
        }

        buffer.Sample(10 / 60.0, pose);
        Assert.Equal(9, pose[0].Position.X);
    }

    private static byte[] CalculationRow() => System.Text.Encoding.ASCII.GetBytes(string.Join('\t', Enumerable.Repeat("0.5", 946)) + "\n");
}
