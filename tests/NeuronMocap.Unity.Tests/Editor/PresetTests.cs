using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using NeuronMocap.Unity.EditorTools;
using UnityEditor;

namespace NeuronMocap.Unity.Tests.Editor;

public class PresetTests
{
    [Theory]
    [InlineData("Simulator", SourceKind.Simulator, TransportKind.Tcp, 7001)]
    [InlineData("Axis Studio on This Computer (UDP 7012)", SourceKind.Network, TransportKind.Udp, 7012)]
    [InlineData("BVH File", SourceKind.BvhFile, TransportKind.Tcp, 7001)]
    [InlineData("Recording", SourceKind.Recording, TransportKind.Tcp, 7001)]
    public void A_preset_of_a_source_sets_its_fields_with_Undo(string preset, SourceKind kind, TransportKind transport, int port)
    {
        using var world = new EditorWorld();
        MocapSource source = world.AddSource(static _ => { });
        Action inspector = world.Inspect(source).OnInspectorGUI;
        ImmediateGui.Draw(inspector);
        Assert.Equal("Axis Neuron on This Computer (TCP 7001)", Shown(SourcePresets.Label));

        ImmediateGui.Set(inspector, SourcePresets.Label, preset);
        ImmediateGui.Draw(inspector);
        Assert.Equal((kind, transport, port), (source.Kind, source.Transport, source.Port));
        Assert.Equal(preset, Shown(SourcePresets.Label));

        Undo.PerformUndo();
        Assert.Equal((SourceKind.Network, TransportKind.Tcp, 7001), (source.Kind, source.Transport, source.Port));
    }

    [Fact]
    public void Settings_without_a_preset_are_custom_and_stay()
    {
        using var world = new EditorWorld();
        MocapSource source = world.AddSource(static source => source.Address = "192.168.1.20");
        MocapSource other = world.AddSource(static source => source.Kind = SourceKind.Simulator);
        Action inspector = world.Inspect(source, other).OnInspectorGUI;

        ImmediateGui.Draw(inspector);
        Assert.Equal("Custom", Shown(SourcePresets.Label));
        Assert.Equal(("192.168.1.20", SourceKind.Simulator), (source.Address, other.Kind));

        ImmediateGui.Set(inspector, SourcePresets.Label, "Axis Neuron on This Computer (TCP 7001)");
        Assert.Equal(("127.0.0.1", SourceKind.Network), (source.Address, other.Kind));
    }

    [Theory]
    [InlineData("Light", 6, 6)]
    [InlineData("Medium", 3, 2)]
    [InlineData("Strong", 1, 1)]
    [InlineData("Fingers Only", 30, 2)]
    public void A_preset_smooths_all_parts_with_Undo(string preset, float body, float fingers)
    {
        using var world = new EditorWorld();
        HumanoidDriver driver = AddDriver();
        driver.PartSmoothing.Set(BodyParts.All, new SmoothingAmount(5, 5));
        Action inspector = world.Inspect(driver).OnInspectorGUI;
        ImmediateGui.Draw(inspector);
        Assert.Equal("Off", Shown(SmoothingPresets.Label));

        ImmediateGui.Set(inspector, SmoothingPresets.Label, preset);
        ImmediateGui.Draw(inspector);
        Assert.True(driver.Smoothing);
        Assert.Equal((body, body, fingers), (driver.PartSmoothing.Get(BodyParts.Hips).MinCutoff, driver.PartSmoothing.Get(BodyParts.LeftLeg).MinCutoff, driver.PartSmoothing.Get(BodyParts.LeftFingers).MinCutoff));
        Assert.Equal(preset, Shown(SmoothingPresets.Label));

        driver.PartSmoothing.Set(BodyParts.Arms, new SmoothingAmount(4, 4));
        ImmediateGui.Draw(inspector);
        Assert.Equal("Custom", Shown(SmoothingPresets.Label));

        ImmediateGui.Set(inspector, SmoothingPresets.Label, "Off");
        Assert.False(driver.Smoothing);
        Undo.PerformUndo();
        Undo.PerformUndo();
        Assert.False(driver.Smoothing);
        Assert.Equal(5, driver.PartSmoothing.Get(BodyParts.Hips).MinCutoff);
    }

    // Otherwise Unity forgets the changes of an instance when its scene is saved.
    [Fact]
    public void Presets_tell_Unity_what_they_change_in_instances_of_prefabs()
    {
        using var world = new EditorWorld();
        MocapSource[] sources = [world.AddSource(static _ => { }), world.AddSource(static _ => { })];
        ImmediateGui.Set(world.Inspect(sources).OnInspectorGUI, SourcePresets.Label, "Simulator");
        Assert.All(sources, static source => Assert.Contains(source, PrefabUtility.Recorded));

        ImmediateGui.Set(world.Inspect(sources).OnInspectorGUI, SourcePresets.Label, "Axis Studio on This Computer (UDP 7012)");
        Assert.All(sources, static source => Assert.Equal(2, PrefabUtility.Recorded.Count(recorded => recorded == source)));

        HumanoidDriver[] drivers = [AddDriver(), AddDriver()];
        ImmediateGui.Set(world.Inspect(drivers).OnInspectorGUI, SmoothingPresets.Label, "Medium");
        Assert.All(drivers, static driver => Assert.Contains(driver, PrefabUtility.Recorded));

        ImmediateGui.Set(world.Inspect(drivers).OnInspectorGUI, SmoothingPresets.Label, "Off");
        Assert.All(drivers, static driver => Assert.Equal(2, PrefabUtility.Recorded.Count(recorded => recorded == driver)));
    }

    private static HumanoidDriver AddDriver() => HumanoidFigure.Build(SkeletonBody.GetDefault()).Root.AddComponent<HumanoidDriver>();

    private static string Shown(string label) => EditorWorld.Controls.Single(control => control.Kind == "Popup" && control.Label == label).Value;
}
