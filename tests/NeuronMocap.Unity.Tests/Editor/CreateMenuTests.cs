using System.Text.RegularExpressions;
using NeuronMocap.Unity.EditorTools;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.Tests.Editor;

public sealed partial class CreateMenuTests
{
    [Fact]
    public void A_source_is_created_below_the_selection_with_Undo()
    {
        using var world = new EditorWorld();
        var parent = new GameObject("Stage");
        CreateMenu.CreateSource(new MenuCommand(parent));

        MocapSource source = Assert.Single(SceneSources.Find());
        Assert.Same(parent.transform, source.transform.parent);
        Assert.Same(source.gameObject, Selection.activeGameObject);

        Undo.PerformUndo();
        Assert.Empty(SceneSources.Find());
        Assert.True(parent != null);
    }

    [Fact]
    public void A_driver_is_added_to_selected_figures_without_one()
    {
        using var world = new EditorWorld();
        var empty = new GameObject("Empty");
        var figure = new GameObject("Figure");
        figure.AddComponent<Animator>();

        Selection.objects = [empty];
        Assert.False(CreateMenu.CanAddHumanoidDriver());
        Selection.objects = [figure];
        Assert.True(CreateMenu.CanAddHumanoidDriver());
        CreateMenu.AddHumanoidDriver();
        Assert.NotNull(figure.GetComponent<HumanoidDriver>());
        Assert.False(CreateMenu.CanAddHumanoidDriver());

        Undo.PerformUndo();
        Assert.True(figure.GetComponent<HumanoidDriver>() == null);
    }

    [Theory]
    [InlineData("Performer Spawner", typeof(PerformerSpawner))]
    [InlineData("Skeleton View", typeof(SkeletonView))]
    [InlineData("Performer Overlay", typeof(PerformerOverlay))]
    public void Components_are_created_from_the_menu_with_Undo(string name, Type type)
    {
        using var world = new EditorWorld();
        Assert.True(MenuItems.Execute($"GameObject/NeuronMocap/{name}"));

        Component made = Assert.Single(Object.FindObjectsOfType<GameObject>()).GetComponent(type)!;
        Assert.Equal((name, (Transform?)null), (made.name, made.transform.parent));
        Assert.Same(made.gameObject, Selection.activeGameObject);

        Undo.PerformUndo();
        Assert.Empty(Object.FindObjectsOfType<GameObject>());
    }

    [Theory]
    [InlineData("Source")]
    [InlineData("Quick Start Scene")]
    public void New_objects_become_parts_of_the_prefab_that_is_open(string entry)
    {
        using var world = new EditorWorld();
        Camera camera = MakeMainCamera(new Vector3(0, 1, -10));
        MocapSource outside = world.AddSource(static _ => { }, "A");
        PrefabStage stage = PrefabStage.Open(new GameObject("Prefab"));

        Assert.True(MenuItems.Execute($"GameObject/NeuronMocap/{entry}"));

        GameObject[] made = [.. Object.FindObjectsOfType<GameObject>().Where(item => item != camera.gameObject && item != outside.gameObject)];
        Assert.All(made, item => Assert.Equal(stage.scene, item.scene));
        MocapSource inside = Assert.Single(SceneSources.Find(), source => source != outside);
        Assert.Same(stage.prefabContentsRoot.transform, inside.transform.parent);
        Assert.All(Object.FindObjectsOfType<HumanoidDriver>(), driver => Assert.Same(inside, driver.Source));
        Assert.True(camera.GetComponent<FollowCamera>() == null);
    }

    [Fact]
    public void Objects_of_hidden_scenes_are_not_of_the_user()
    {
        using var world = new EditorWorld();
        MocapSource hidden = world.AddSource(static _ => { });
        Light light = new GameObject("Light").AddComponent<Light>();
        FigureDriver figure = new GameObject("Figure").AddComponent<GenericRigDriver>();
        Scene preview = EditorSceneManager.NewPreviewScene();
        foreach (Component item in (Component[])[hidden, light, figure])
            SceneManager.MoveGameObjectToScene(item.gameObject, preview);

        Assert.Empty(SceneSources.Find());
        Assert.False(LivePreview.CanStart(hidden));
        Assert.False(OpenScenes.Contains(figure));
        CreateMenu.CreateQuickStart();
        Assert.NotSame(hidden, Assert.Single(SceneSources.Find()));
        Assert.True(Object.FindObjectOfType<StageBuilder>()!.HasLight);
    }

    [Fact]
    public void A_spawner_gets_the_first_source_of_its_scene()
    {
        using var world = new EditorWorld();
        MocapSource elsewhere = world.AddSource(static _ => { }, "A");
        SceneManager.MoveGameObjectToScene(elsewhere.gameObject, EditorWorld.AddScene("Other"));
        world.AddSource(static _ => { }, "C");
        MocapSource first = world.AddSource(static _ => { }, "B");

        Assert.True(MenuItems.Execute("GameObject/NeuronMocap/Performer Spawner"));

        Assert.Same(first, Object.FindObjectOfType<PerformerSpawner>()!.Source);
    }

    [Fact]
    public void A_generic_driver_is_added_to_every_selected_figure_without_one()
    {
        const string Entry = "GameObject/NeuronMocap/Generic Rig Driver on Selection";
        using var world = new EditorWorld();
        Assert.False(MenuItems.Execute(Entry));

        var first = new GameObject("First");
        var second = new GameObject("Second");
        GenericRigDriver driver = second.AddComponent<GenericRigDriver>();
        Selection.objects = [first, second];
        Assert.True(MenuItems.Execute(Entry));
        Assert.NotNull(first.GetComponent<GenericRigDriver>());
        Assert.Same(driver, Assert.Single(second.GetComponents<GenericRigDriver>()));
        Assert.False(MenuItems.Execute(Entry));

        Undo.PerformUndo();
        Assert.True(first.GetComponent<GenericRigDriver>() == null);
        Assert.True(driver != null);
    }

    [Fact]
    public void The_quick_start_is_one_Undo_step_and_reuses_a_source()
    {
        using var world = new EditorWorld();
        CreateMenu.CreateQuickStart();

        MocapSource source = Assert.Single(SceneSources.Find());
        Assert.Equal(SourceKind.Simulator, source.Kind);
        Assert.Same(source, Object.FindObjectOfType<FigureBuilder>()!.GetComponent<HumanoidDriver>().Source);
        Assert.NotNull(Object.FindObjectOfType<StageBuilder>());

        Undo.PerformUndo();
        Assert.Empty(Object.FindObjectsOfType<GameObject>());
    }

    [Fact]
    public void The_main_camera_of_a_new_scene_follows_the_figure_from_the_front()
    {
        using var world = new EditorWorld();
        Transform eye = MakeMainCamera(new Vector3(0, 1, -10)).transform;
        CreateMenu.CreateQuickStart();

        Transform figure = Object.FindObjectOfType<FigureBuilder>()!.transform;
        Assert.Same(figure, eye.GetComponent<FollowCamera>().Target);
        Assert.InRange(figure.InverseTransformPoint(eye.position).z, 2, 5);
        Assert.True(Vector3.Angle(eye.forward, figure.position + Vector3.up - eye.position) < 1);
        Assert.Contains(eye, PrefabUtility.Recorded);

        // A second quick start leaves the camera with the first figure.
        ConsoleLog.Clear();
        Undo.IncrementCurrentGroup();
        CreateMenu.CreateQuickStart();
        Assert.Same(figure, eye.GetComponent<FollowCamera>().Target);
        Assert.Empty(ConsoleLog.Entries);
        Undo.PerformUndo();

        Undo.PerformUndo();
        Assert.Equal(new Vector3(0, 1, -10), eye.position);
        Assert.True(eye.GetComponent<FollowCamera>() == null);
    }

    [Fact]
    public void A_camera_that_was_placed_stays_and_the_console_says_how_to_follow()
    {
        using var world = new EditorWorld();
        Camera camera = MakeMainCamera(new Vector3(0, 1.5f, 4));
        CreateMenu.CreateQuickStart();

        Assert.Equal(new Vector3(0, 1.5f, 4), camera.transform.position);
        Assert.True(camera.GetComponent<FollowCamera>() == null);
        LogEntry entry = Assert.Single(ConsoleLog.Entries);
        Assert.Contains("Follow Camera", entry.Message, StringComparison.Ordinal);
        Assert.Equal(LogType.Log, entry.Type);
    }

    [Fact]
    public void Every_menu_item_that_a_text_names_exists()
    {
        string[] kinds = [".cs", ".md"];
        string[] items = [.. MenuItems.Paths.Select(static path => path.Replace("/", " > ", StringComparison.Ordinal))];
        List<string> unknown = [];
        foreach (string file in Directory.EnumerateFiles(Path.Combine(Repository.Root, "unity-package"), "*", SearchOption.AllDirectories).Where(file => kinds.Contains(Path.GetExtension(file))))
        {
            foreach (Match named in MenuPath().Matches(File.ReadAllText(file)))
            {
                if (!items.Any(item => named.Value.StartsWith(item, StringComparison.Ordinal)))
                    unknown.Add($"{Path.GetFileName(file)}: {named.Value}");
            }
        }

        Assert.Empty(unknown);
    }

    [Fact]
    public void The_figure_of_the_quick_start_leaves_the_origin_to_a_character_of_the_user()
    {
        using var world = new EditorWorld();
        CreateMenu.CreateQuickStart();
        Assert.InRange(Object.FindObjectOfType<FigureBuilder>()!.transform.position.magnitude, 0.8f, 2);
    }

    private static Camera MakeMainCamera(Vector3 position)
    {
        var eye = new GameObject("Main Camera") { tag = "MainCamera" };
        eye.transform.position = position;
        return eye.AddComponent<Camera>();
    }

    [GeneratedRegex("(GameObject|Window|Tools) > NeuronMocap > [A-Za-z ]+", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex MenuPath();
}
