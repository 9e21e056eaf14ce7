using UnityEditor;

namespace NeuronMocap.Unity.Tests.StandIn;

public sealed class PlayModeTests : IDisposable
{
    private readonly PlayerLoop _loop = new(play: false);
    private readonly List<string> _events = [];

    public PlayModeTests() => Probe.Clear();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void Play_mode_wakes_and_restores_the_scene()
    {
        GameObject item = new("A");
        item.AddComponent<Probe>();
        new GameObject("E").AddComponent<EditProbe>();
        Assert.Equal(["E.Awake", "E.OnEnable"], Probe.Calls);
        Probe.Clear();

        _loop.EnterPlayMode();
        Assert.Equal(["A.Awake", "A.OnEnable"], Probe.Calls);
        Probe.Clear();
        _loop.Frame(0.001f);
        item.transform.position = Vector3.one;
        Probe.Clear();

        _loop.ExitPlayMode();

        Assert.Equal(["A.OnApplicationQuit", "E.OnApplicationQuit", "A.OnDisable", "A.OnDestroy", "E.OnDisable", "E.OnDestroy", "E.Awake", "E.OnEnable"], Probe.Calls);
        Assert.False(item);
        Assert.Equal(Vector3.zero, GameObject.Find("A")!.transform.position);
        Assert.False(Application.isPlaying);
    }

    [Fact]
    public void Another_project_ends_the_game()
    {
        _loop.EnterPlayMode();
        using var next = new PlayerLoop(play: false);
        Assert.False(EditorApplication.isPlayingOrWillChangePlaymode);
    }

    [Fact]
    public void The_editor_reports_its_steps_in_order()
    {
        EditorApplication.playModeStateChanged += change => _events.Add($"{change}");
        Application.quitting += () => _events.Add("quitting");
        new GameObject("A").AddComponent<Probe>();

        _loop.EnterPlayMode(reloadDomain: false);
        _loop.ExitPlayMode();

        Assert.Equal(["ExitingEditMode", "EnteredPlayMode", "ExitingPlayMode", "quitting", "EnteredEditMode"], _events);
    }

    [Fact]
    public void A_reload_drops_handlers_and_reports_before_and_after()
    {
        AssemblyReloadEvents.beforeAssemblyReload += () => _events.Add("before");
        AssemblyReloadEvents.afterAssemblyReload += () => _events.Add("after");
        Application.quitting += () => _events.Add("quitting");

        _loop.EnterPlayMode(reloadDomain: true);
        _loop.ExitPlayMode();

        Assert.Equal(["before"], _events);
    }

    [Fact]
    public void Scripts_compiled_in_play_mode_keep_what_Unity_can_keep()
    {
        _loop.EnterPlayMode();
        Worker worker = new GameObject("A").AddComponent<Worker>();
        worker.Work();

        _loop.ReloadDomain();

        Assert.Equal((5, 0, (Action?)null), worker.Fields);
        Assert.Equal(["OnEnable", "OnDisable", "OnEnable"], worker.Calls);
        Assert.True(worker.isActiveAndEnabled);
    }

    [Fact]
    public void An_editor_script_may_leave_play_mode()
    {
        _loop.EnterPlayMode();
        EditorApplication.isPlaying = false;
        Assert.True(Application.isPlaying);
        _loop.Frame();
        Assert.False(Application.isPlaying);
    }

    // Without a domain reload, statics survive. A method of their class must reset them.
    [Fact]
    public void A_reload_resets_statics()
    {
        Statics.Count = 5;
        Statics.List.Add("x");

        ScriptStatics.Reset(typeof(Statics));

        Assert.Equal(1, Statics.Count);
        Assert.Empty(Statics.List);
    }

    private static class Statics
    {
        public static int Count { get; set; } = 1;

        public static List<string> List { get; private set; } = [];
    }

    private sealed class Worker : MonoBehaviour
    {
        [SerializeField]
        private List<string>? _calls;

        private int _kept;

        [NonSerialized]
        private int _forgotten;

        private Action? _callback;

        public (int Kept, int Forgotten, Action? Callback) Fields => (_kept, _forgotten, _callback);

        public IReadOnlyList<string>? Calls => _calls;

        public void Work() => (_kept, _forgotten, _callback) = (5, 6, Work);

        private void OnEnable() => (_calls ??= []).Add("OnEnable");

        private void OnDisable() => _calls!.Add("OnDisable");
    }
}
