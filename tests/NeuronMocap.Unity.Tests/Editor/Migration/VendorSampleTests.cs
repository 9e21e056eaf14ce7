using NeuronMocap.Unity.EditorTools;
using NeuronMocap.Unity.Samples;
using NeuronMocap.Unity.Tests.Samples;
using UnityEditor;
using UnityEditor.SceneManagement;

namespace NeuronMocap.Unity.Tests.Editor.Migration;

/// <summary>The sample that shows the conversion, from the scene with missing scripts to characters that move.</summary>
public sealed class VendorSampleTests : IDisposable
{
    private const string ScenePath = "Assets/VendorComponents.unity";

    private readonly VendorProject _project = new(hasScripts: false);

    public void Dispose() => _project.Dispose();

    [Fact]
    public void The_scene_is_converted_and_its_characters_walk()
    {
        Open();
        Assert.Empty(Object.FindObjectsOfType<FigureDriver>());

        IReadOnlyList<MigrationItem> planned = EditorTools.Migration.Examine();
        Assert.Equal(
            ["Humanoid Driver, performer 0 of a new Mocap Source, 127.0.0.1:7001", "Generic Rig Driver, performer 0 of the Mocap Source, 127.0.0.1:7001"],
            planned.Select(static item => item.Change));
        Assert.All(planned, static item => Assert.True(item.IsConvertible && item.Notes.Count == 0, item.ToString()));
        EditorTools.Migration.Convert();
        Assert.Empty(EditorTools.Migration.Examine());

        // The scene names a port. The test leaves the choice to the system.
        Object.FindObjectsOfType<MocapSource>().Single().enabled = false;
        SceneFile.FindField(typeof(SuitServer), "_port")!.SetValue(Object.FindObjectsOfType<SuitServer>().Single(), 0);
        _project.World.Loop.EnterPlayMode();
        MocapSource source = Object.FindObjectsOfType<MocapSource>().Single();
        source.Port = Object.FindObjectsOfType<SuitServer>().Single().Port;
        source.enabled = true;

        FigureDriver[] drivers = Object.FindObjectsOfType<FigureDriver>();
        Assert.Equal(2, drivers.Length);
        _project.World.Loop.RunUntil(() => drivers.All(static driver => driver.IsDriving));
        Transform[] legs = [.. drivers.Select(static driver => driver.GetComponentsInChildren<Transform>().Single(static part => part.name == "LeftUpLeg"))];
        Quaternion[] start = [.. legs.Select(static leg => leg.localRotation)];
        _project.World.Loop.RunUntil(() => legs.Zip(start).All(static pair => Quaternion.Angle(pair.First.localRotation, pair.Second) > 3));
        _project.World.Loop.ExitPlayMode();
    }

    [Fact]
    public void Undo_brings_the_missing_scripts_back()
    {
        Open();
        EditorTools.Migration.Convert();
        Assert.Equal(2, Object.FindObjectsOfType<FigureDriver>().Length);

        Undo.PerformUndo();

        Assert.Empty(Object.FindObjectsOfType<FigureDriver>());
        Assert.Equal(2, EditorTools.Migration.Examine().Count);
    }

    [Fact]
    public void A_server_whose_port_is_taken_says_so()
    {
        using var server = new NeuronMocap.Server.Broadcaster(new NeuronMocap.Server.BroadcasterOptions { Sources = [new NeuronMocap.Server.SyntheticSource()], Port = 0 });
        server.Start();
        _project.World.Loop.EnterPlayMode();
        var holder = new GameObject("Suit server");
        holder.SetActive(false);
        SuitServer second = holder.AddComponent<SuitServer>();
        SceneFile.FindField(typeof(SuitServer), "_port")!.SetValue(second, server.LocalEndPoint!.Port);

        holder.SetActive(true);

        Assert.Equal(0, second.Port);
        Assert.Contains("the scene receives from it", Assert.Single(ConsoleLog.Entries).Message, StringComparison.Ordinal);
    }

    private static void Open()
    {
        string scene = Path.Combine(Repository.Root, "unity-package", "Samples~", "VendorComponents", "VendorComponents.unity");
        AssetDatabase.AddFile(ScenePath, File.ReadAllText(scene));
        foreach (string guid in SceneFile.Read(scene).Scripts.Select(SceneFile.Guid).Except(SceneFile.VendorScripts).Distinct())
            AssetDatabase.AddScript(guid, SceneFile.FindScript(guid));

        EditorSceneManager.OpenScene(ScenePath, OpenSceneMode.Single);
    }
}
