using System.Collections;

namespace NeuronMocap.Unity.Tests.StandIn;

public sealed class CoroutineTests : IDisposable
{
    private readonly PlayerLoop _loop = new();
    private readonly List<string> _steps = [];

    public void Dispose() => _loop.Dispose();

    [Fact]
    public void Coroutines_resume_when_their_wait_ends()
    {
        Runner runner = new GameObject("A").AddComponent<Runner>();
        runner.StartCoroutine(Outer(runner));
        Assert.Equal(["begin"], _steps);

        _loop.Frame(0.1f);
        Assert.Equal(["begin", "next"], _steps);
        _loop.Frames(4, 0.1f);
        Assert.DoesNotContain("second", _steps);
        _loop.Frame(0.1f);
        Assert.Equal(["begin", "next", "second", "inner", "inner end", "end"], _steps);
    }

    [Fact]
    public void Coroutines_end_with_their_objects_activity()
    {
        Runner runner = new GameObject("A").AddComponent<Runner>();
        runner.StartCoroutine(Endless());

        runner.enabled = false;
        _loop.Frames(2);
        Assert.Equal(3, _steps.Count);

        runner.gameObject.SetActive(false);
        runner.gameObject.SetActive(true);
        _loop.Frames(2);
        Assert.Equal(3, _steps.Count);

        Coroutine running = runner.StartCoroutine(Endless())!;
        runner.StopCoroutine(running);
        _loop.Frames(2);
        Assert.Equal(4, _steps.Count);
    }

    [Fact]
    public void Start_may_be_one()
    {
        Runner runner = new GameObject("A").AddComponent<Runner>();

        _loop.Frame();
        Assert.Equal(1, runner.Progress);
        _loop.Frame();
        Assert.Equal(2, runner.Progress);
    }

    [Fact]
    public void An_await_returns_to_the_main_thread()
    {
        Runner runner = new GameObject("A").AddComponent<Runner>();
        runner.GoOn();

        _loop.RunUntil(() => runner.name == "awaited");
        Assert.Empty(ConsoleLog.Problems);
    }

    private IEnumerator Outer(Runner runner)
    {
        _steps.Add("begin");
        yield return null;
        _steps.Add("next");
        yield return new WaitForSeconds(0.45f);
        _steps.Add("second");
        yield return runner.StartCoroutine(Inner());
        _steps.Add("end");
    }

    private IEnumerator Inner()
    {
        _steps.Add("inner");
        yield return new WaitForEndOfFrame();
        _steps.Add("inner end");
    }

    private IEnumerator Endless()
    {
        while (true)
        {
            _steps.Add("step");
            yield return null;
        }
    }

    private sealed class Runner : MonoBehaviour
    {
        private bool _goesOn;

        public int Progress { get; private set; }

        public void GoOn() => _goesOn = true;

        private IEnumerator Start()
        {
            Progress++;
            yield return null;
            Progress++;
        }

        private void Update()
        {
            if (_goesOn)
                _ = WaitAsync();

            _goesOn = false;
        }

        private async Task WaitAsync()
        {
            await Task.Run(static () => { });
            name = "awaited";
        }
    }
}
