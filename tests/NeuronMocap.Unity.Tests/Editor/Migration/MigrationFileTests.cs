using NeuronMocap.Unity.EditorTools;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.Tests.Editor.Migration;

/// <summary>The conversion of scenes and prefabs in files, with and without the vendor's scripts.</summary>
public sealed class MigrationFileTests : IDisposable
{
    private const string ScenePath = "Assets/Show.unity";
    private const string PrefabPath = "Assets/Figure.prefab";

    private VendorProject _project = new(hasScripts: false);

    public void Dispose() => _project.Dispose();

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_closed_scene_is_converted_and_saved(bool hasScripts)
    {
        UseProject(hasScripts);
        AddScene();
        string before = VendorProject.Read(ScenePath);

        IReadOnlyList<MigrationItem> planned = EditorTools.Migration.Examine();
        Assert.Equal(before, VendorProject.Read(ScenePath));
        IReadOnlyList<MigrationItem> items = EditorTools.Migration.Convert();

        Assert.Equal(planned.Select(static item => item.ToString()), items.Select(static item => item.ToString()));
        Assert.All(items, static item => Assert.True(item.IsConvertible, item.Reason));
        Assert.Equal(1, SceneManager.sceneCount);
        Assert.Empty(Object.FindObjectsOfType<GameObject>(true));
        Assert.Empty(EditorTools.Migration.Examine());

        EditorSceneManager.OpenScene(ScenePath, OpenSceneMode.Single);
        AssertConverted();
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void An_open_scene_is_converted_with_Undo(bool hasScripts)
    {
        UseProject(hasScripts);
        AddScene();
        EditorSceneManager.OpenScene(ScenePath, OpenSceneMode.Single);
        string[] before = [.. EditorTools.Migration.Examine().Select(static item => item.ToString())];

        EditorTools.Migration.Convert();

        AssertConverted();
        Assert.True(SceneManager.GetActiveScene().isDirty);
        Assert.Empty(EditorTools.Migration.Examine());

        Undo.PerformUndo();
        Assert.Empty(Object.FindObjectsOfType<FigureDriver>());
        Assert.Equal(before, EditorTools.Migration.Examine().Select(static item => item.ToString()));
    }

    [Fact]
    public void Scenes_without_vendor_components_are_not_opened()
    {
        AssetDatabase.AddFile("Assets/Empty.unity", VendorProject.File(VendorProject.Object(1, "Nothing")));
        EditorSceneManager.Opened.Clear();

        Assert.Empty(EditorTools.Migration.Convert());
        Assert.Empty(EditorSceneManager.Opened);
    }

    [Fact]
    public void A_prefab_that_Unity_does_not_save_is_reported()
    {
        AssetDatabase.AddFile(PrefabPath, VendorProject.File(
            VendorProject.Object(1, "Figure"),
            VendorProject.Script(3, 1, VendorProject.AnimatorGuid, "port: 7001"),
            VendorProject.Object(10, "Sword", father: 2),
            VendorProject.Script(12, 10, VendorProject.UnknownGuid, "speed: 3")));
        string before = VendorProject.Read(PrefabPath);

        MigrationItem item = Assert.Single(EditorTools.Migration.Convert(), static item => !item.IsConvertible);

        Assert.Equal("It could not be saved, so its file has not changed.", item.Reason);
        Assert.Equal(before, VendorProject.Read(PrefabPath));
    }

    [Fact]
    public void Models_are_not_read()
    {
        AssetDatabase.AddFile("Assets/Model.fbx", "Kaydara FBX Binary");
        Assert.Empty(EditorTools.Migration.Examine());
    }

    [Fact]
    public void Other_missing_scripts_are_not_lost()
    {
        AssetDatabase.AddFile(ScenePath, VendorProject.File(
            VendorProject.Object(1, "Figure"),
            VendorProject.Script(3, 1, VendorProject.AnimatorGuid, "port: 7001"),
            VendorProject.Script(4, 1, VendorProject.UnknownGuid, "speed: 3")));
        string before = VendorProject.Read(ScenePath);

        MigrationItem item = Assert.Single(EditorTools.Migration.Convert());

        Assert.Contains("other missing scripts", item.Reason, StringComparison.Ordinal);
        Assert.Equal(before, VendorProject.Read(ScenePath));
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_model_of_a_scene_gets_its_driver(bool hasScripts)
    {
        UseProject(hasScripts);
        string model = AssetDatabase.AddFile("Assets/Model.prefab", VendorProject.File(VendorProject.Object(10, "Model"), VendorProject.Animator(12, 10)));
        AssetDatabase.AddFile(ScenePath, VendorProject.File(
            VendorProject.Instance(500, model),
            VendorProject.Stub(1, 501, 10, model, 500),
            VendorProject.Stub(95, 502, 12, model, 500),
            VendorProject.Script(503, 501, VendorProject.AnimatorGuid, "address: 127.0.0.1", "port: 7001", "actorID: 3", "boundAnimator: {fileID: 502}")));

        MigrationItem item = Assert.Single(EditorTools.Migration.Convert());

        Assert.Equal("Model: NeuronAnimatorInstance", item.Place);
        EditorSceneManager.OpenScene(ScenePath, OpenSceneMode.Single);
        HumanoidDriver driver = Assert.Single(Object.FindObjectsOfType<HumanoidDriver>());
        Assert.Equal(("Model", 3), (driver.name, driver.PerformerIndex));
        Assert.Same(driver.GetComponent<Animator>(), driver.Animator);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_prefab_carries_its_source(bool hasScripts)
    {
        UseProject(hasScripts);
        string prefab = AddPrefab();

        IReadOnlyList<MigrationItem> items = EditorTools.Migration.Convert();

        Assert.All(items, static item => Assert.True(item.IsConvertible, item.Reason));
        Assert.Equal(2, items.Count);
        Assert.Contains(AssetDatabase.GetScriptGuid(typeof(HumanoidDriver)), VendorProject.Read(PrefabPath), StringComparison.Ordinal);
        Assert.DoesNotContain(VendorProject.AnimatorGuid, VendorProject.Read(PrefabPath), StringComparison.Ordinal);
        Assert.Empty(EditorTools.Migration.Examine());

        // Both performers use the source of the first one.
        GameObject root = AssetDatabase.LoadAssetAtPath<GameObject>(AssetDatabase.GUIDToAssetPath(prefab))!;
        MocapSource source = Assert.Single(root.GetComponentsInChildren<MocapSource>(true));
        Assert.Same(root, source.gameObject);
        Assert.Equal([0, 1], root.GetComponentsInChildren<HumanoidDriver>(true).Select(static driver => driver.PerformerIndex));
        Assert.All(root.GetComponentsInChildren<HumanoidDriver>(true), driver => Assert.Same(source, driver.Source));
    }

    [Fact]
    public void A_prefab_whose_object_has_another_source_is_left()
    {
        AssetDatabase.AddFile(PrefabPath, VendorProject.File(
            VendorProject.Object(1, "Figure"),
            VendorProject.Script(3, 1, VendorProject.AnimatorGuid, "port: 7001"),
            VendorProject.Script(4, 1, AssetDatabase.GetScriptGuid(typeof(MocapSource)), "_port: 7009")));

        Assert.Contains("Mocap Source with other settings", Assert.Single(EditorTools.Migration.Convert()).Reason, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Changes_of_an_instance_are_listed(bool hasScripts)
    {
        UseProject(hasScripts);
        string prefab = AddPrefab();
        AssetDatabase.AddFile(ScenePath, VendorProject.File(VendorProject.Instance(500, prefab, 3, ("m_Name", "Guest"), ("actorID", "4"), ("address", "10.0.0.7"))));
        EditorSceneManager.OpenScene(ScenePath, OpenSceneMode.Single);
        GameObject instance = GameObject.Find("Figure")!;

        MigrationItem item = EditorTools.Migration.Convert().Single(static item => item.File == ScenePath);

        Assert.Contains("actorID = 4, address = 10.0.0.7.", item.Reason, StringComparison.Ordinal);
        Assert.Equal($"Instance of {PrefabPath}", item.Place);

        // The instance follows its prefab, so it is not converted itself.
        Assert.Null(instance.GetComponent<HumanoidDriver>());
        Assert.Empty(instance.GetComponentsInChildren<NeuronAnimatorInstance>());
        Assert.Empty(EditorTools.Migration.Examine());
    }

    [Fact]
    public void A_binary_file_is_listed()
    {
        AssetDatabase.AddFile(ScenePath, "\0\0\0\u0001binary");

        Assert.Contains("Force Text", Assert.Single(EditorTools.Migration.Convert()).Reason, StringComparison.Ordinal);
    }

    [Fact]
    public void Text_with_quotes_is_read()
    {
        AssetDatabase.AddFile(ScenePath, VendorProject.File(
            VendorProject.Object(1, "Rig"),
            VendorProject.Script(3, 1, VendorProject.TransformsGuid, "address: \"studio \\\"A\\\"\"", "port: 7001", "prefix: 'Bob''s '", "root: {fileID: 2}")));
        EditorSceneManager.OpenScene(ScenePath, OpenSceneMode.Single);

        EditorTools.Migration.Convert();

        GenericRigDriver driver = Object.FindObjectOfType<GenericRigDriver>()!;
        Assert.Equal(("studio \"A\"", "Bob's "), (driver.Source!.Address, driver.Prefix));
        Assert.Same(driver.transform, driver.Root);
    }

    private static void AddScene() => AssetDatabase.AddFile(ScenePath, VendorProject.File(
        VendorProject.Object(1, "First"),
        VendorProject.Animator(3, 1),
        VendorProject.Script(4, 1, VendorProject.AnimatorGuid, "address: 10.0.0.9", "port: 7002", "socketType: 0", "actorID: 1", "boundAnimator: {fileID: 3}"),
        VendorProject.Object(11, "Second"),
        VendorProject.Script(13, 11, VendorProject.AnimatorGuid, "address: 10.0.0.9", "port: 7002", "socketType: 0", "actorID: 0", "boundAnimator: {fileID: 0}"),
        VendorProject.Object(21, "Robot", father: 12),
        VendorProject.Script(23, 21, VendorProject.TransformsGuid, "address: 127.0.0.1", "port: 7003", "socketType: 1", "actorID: 0", "root: {fileID: 22}", "prefix: Robot_")));

    private static void AssertConverted()
    {
        Assert.Equal(2, Object.FindObjectsOfType<MocapSource>().Length);
        (HumanoidDriver first, HumanoidDriver second) = (Get<HumanoidDriver>("First"), Get<HumanoidDriver>("Second"));
        GenericRigDriver robot = Get<GenericRigDriver>("Second/Robot");
        Assert.Same(first.Source, second.Source);
        Assert.Equal(("10.0.0.9", 7002, 1, 0), (first.Source!.Address, first.Source.Port, first.PerformerIndex, second.PerformerIndex));
        Assert.Same(first.GetComponent<Animator>(), first.Animator);
        Assert.Null(second.Animator);
        Assert.Equal((TransportKind.Udp, 7003, "Robot_", robot.transform), (robot.Source!.Transport, robot.Source.Port, robot.Prefix, robot.Root));
        Assert.Empty(Object.FindObjectsOfType<Neuron.NeuronInstance>(true));
        Assert.All(Object.FindObjectsOfType<GameObject>(true), static item => Assert.Equal(0, GameObjectUtility.GetMonoBehavioursWithMissingScriptCount(item)));
    }

    private static T Get<T>(string path) => GameObject.Find(path)!.GetComponent<T>();

    private static string AddPrefab() => AssetDatabase.AddFile(PrefabPath, VendorProject.File(
        VendorProject.Object(1, "Figure"),
        VendorProject.Script(3, 1, VendorProject.AnimatorGuid, "address: 127.0.0.1", "port: 7001", "actorID: 0"),
        VendorProject.Object(11, "Partner", father: 2),
        VendorProject.Script(13, 11, VendorProject.AnimatorGuid, "address: 127.0.0.1", "port: 7001", "actorID: 1")));

    private void UseProject(bool hasScripts)
    {
        _project.Dispose();
        _project = new VendorProject(hasScripts);
    }
}
