using NeuronMocap.Unity.Tests.Infrastructure;

namespace NeuronMocap.Unity.Tests.StandIn;

public sealed class LifecycleTests : IDisposable
{
    // Shorter than a physics step, so that no step falls into a frame.
    private const float Short = 0.001f;

    private readonly PlayerLoop _loop = new();

    public LifecycleTests() => Probe.Clear();

    public void Dispose() => _loop.Dispose();

    // A machine that is busy between two clock readings may have no time left for a frame.
    [Fact]
    public void A_run_of_no_time_is_one_frame()
    {
        int before = Time.frameCount;
        _loop.RunFor(0);
        Assert.Equal(before + 1, Time.frameCount);
    }

    // Otherwise the run would end with the stall, and the game would not have moved.
    [Fact]
    public void A_run_plays_its_time_even_if_a_frame_stalls()
    {
        var stalled = new GameObject("Slow").AddComponent<SlowProbe>();
        double before = Time.timeAsDouble;
        _loop.RunFor(SlowProbe.Seconds / 2);

        Assert.True(stalled.HasStalled);
        Assert.True(Time.timeAsDouble - before >= SlowProbe.Seconds / 2 - 1e-6, $"{Time.timeAsDouble - before} s");
    }

    [Fact]
    public void Callbacks_run_in_Unitys_order()
    {
        Probe probe = Add<Probe>("A");
        Expect("A.Awake", "A.OnEnable");

        _loop.Frame(Short);
        Expect("A.Start", "A.Update", "A.LateUpdate");

        probe.gameObject.SetActive(false);
        _loop.Frame(Short);
        Expect("A.OnDisable");

        probe.gameObject.SetActive(true);
        probe.enabled = false;
        probe.enabled = true;
        _loop.Frame(Short);
        Expect("A.OnEnable", "A.OnDisable", "A.OnEnable", "A.Update", "A.LateUpdate");

        Object.Destroy(probe);
        Assert.True(probe);
        Expect();
        _loop.Frame(Short);
        Expect("A.Update", "A.LateUpdate", "A.OnDisable", "A.OnDestroy");
        Assert.False(probe);
        Assert.Empty(ConsoleLog.Entries);
    }

    [Fact]
    public void The_execution_order_precedes_the_order_of_creation()
    {
        Add<Probe>("A");
        Add<EarlyProbe>("B");
        Probe.Clear();

        _loop.Frame(Short);

        Expect("B.Start", "A.Start", "B.Update", "A.Update", "B.LateUpdate", "A.LateUpdate");
    }

    [Fact]
    public void An_inactive_script_gets_no_callbacks()
    {
        var item = new GameObject("A");
        item.SetActive(false);
        item.AddComponent<Probe>();
        _loop.Frame(Short);
        Expect();

        Object.DestroyImmediate(item);
        Expect();

        Probe disabled = Add<Probe>("B", static probe => probe.enabled = false);
        Expect("B.Awake");
        Object.DestroyImmediate(disabled.gameObject);
        Expect("B.OnDestroy");
    }

    [Fact]
    public void A_component_added_within_a_frame_starts_before_its_first_update()
    {
        new GameObject("maker").AddComponent<Maker>();

        _loop.Frame(Short);
        Expect("A.Awake", "A.OnEnable", "A.Start", "A.LateUpdate");

        _loop.Frame(Short);
        Expect("A.Update", "A.LateUpdate");
    }

    [Fact]
    public void Physics_has_its_own_steps()
    {
        Add<Probe>("A");
        Probe.Clear();
        _loop.Frame(0.05f);

        Expect("A.Start", "A.FixedUpdate", "A.FixedUpdate", "A.Update", "A.LateUpdate");
        Assert.Equal(0.05f, Time.deltaTime);
        Assert.Equal(1, Time.frameCount);
    }

    [Fact]
    public void A_script_exception_is_logged_and_the_frame_goes_on()
    {
        Probe.Failing.UnionWith(["Update", "OnDisable"]);
        Probe failing = Add<EarlyProbe>("A");
        Add<Probe>("B");
        Probe.Calls.Clear();

        _loop.Frame(Short);
        Expect("A.Start", "B.Start", "A.Update", "B.Update", "A.LateUpdate", "B.LateUpdate");
        Assert.Equal(2, ConsoleLog.Entries.Count(static entry => entry.Exception is InvalidOperationException));

        Object.DestroyImmediate(failing);
        Expect("A.OnDisable", "A.OnDestroy");
        Assert.Equal(3, ConsoleLog.Problems.Count());

        Probe.Failing.Add("Awake");
        Assert.False(Add<Probe>("C").enabled);
        Expect("C.Awake");
    }

    [Fact]
    public void A_scene_change_keeps_marked_objects()
    {
        Probe kept = Add<Probe>("kept");
        Probe left = Add<Probe>("left");
        Object.DontDestroyOnLoad(kept.gameObject);
        Probe.Clear();

        _loop.ChangeScene("Next", static () => Add<Probe>("new"));

        Expect("left.OnDisable", "left.OnDestroy", "new.Awake", "new.OnEnable");
        Assert.True(kept);
        Assert.False(left);
        Assert.Equal("DontDestroyOnLoad", kept.gameObject.scene.name);
    }

    [Fact]
    public void The_frame_loop_allocates_nothing()
    {
        for (int i = 0; i < 10; i++)
            new GameObject("A").AddComponent<Mover>();

        FrameAllocations.AssertNone(_loop);
    }

    [Fact]
    public void Another_thread_may_not_touch_objects()
    {
        Probe probe = Add<Probe>("A");
        var faults = new List<Exception?>();
        var thread = new Thread(() =>
        {
            faults.Add(Record.Exception(() => probe.transform));
            faults.Add(Record.Exception(() => new GameObject()));
            faults.Add(Record.Exception(() => Time.time));
            faults.Add(Record.Exception(() => Object.Destroy(probe)));
            Debug.Log("may be called anywhere");
        });
        thread.Start();
        thread.Join();

        Assert.All(faults, static fault => Assert.IsType<UnityException>(fault));
        Assert.Equal("may be called anywhere", ConsoleLog.Entries[^1].Message);
    }

    private static T Add<T>(string name, Action<T>? set = null)
        where T : Probe
    {
        var item = new GameObject(name);
        if (set is null)
            return item.AddComponent<T>();

        item.SetActive(false);
        T added = item.AddComponent<T>();
        set(added);
        item.SetActive(true);
        return added;
    }

    private static void Expect(params string[] calls)
    {
        Assert.Equal(calls, Probe.Calls);
        Probe.Calls.Clear();
    }

    private sealed class Maker : MonoBehaviour
    {
        private void Update()
        {
            if (!GameObject.Find("A"))
                Add<Probe>("A");
        }
    }

    private sealed class Mover : MonoBehaviour
    {
        private void Update() => transform.localPosition += Vector3.forward * Time.deltaTime;

        private void LateUpdate() => transform.rotation = Quaternion.Euler(0, Time.time, 0) * transform.rotation;
    }
}
