namespace NeuronMocap.Unity.Tests.StandIn;

public sealed class LifecycleTests : IDisposable
{
    private readonly PlayerLoop _loop = new();

    public LifecycleTests() => Probe.Calls.Clear();

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void Callbacks_come_in_the_engine_s_order()
    {
        Probe probe = new GameObject("A").AddComponent<Probe>();
        Assert.Equal(["Awake", "OnEnable"], Probe.Calls);

        _loop.Frame();
        _loop.Frame();
        probe.gameObject.SetActive(false);
        _loop.Frame();
        probe.gameObject.SetActive(true);
        _loop.Frame();
        Object.Destroy(probe);
        Assert.True(probe);
        _loop.Frame();

        Assert.False(probe);
        Assert.Equal(
            [
                "Awake", "OnEnable", "Start", "Update", "LateUpdate", "Update", "LateUpdate", "OnDisable", "OnEnable", "Update", "LateUpdate", "Update", "LateUpdate",
                "OnDisable", "OnDestroy",
            ],
            Probe.Calls);
        Assert.Empty(ConsoleLog.Entries);
    }

    private sealed class Probe : MonoBehaviour
    {
        public static List<string> Calls { get; } = [];

        private static void Add([System.Runtime.CompilerServices.CallerMemberName] string name = "") => Calls.Add(name);

        private void Awake() => Add();

        private void OnEnable() => Add();

        private void Start() => Add();

        private void Update() => Add();

        private void LateUpdate() => Add();

        private void OnDisable() => Add();

        private void OnDestroy() => Add();
    }
}
