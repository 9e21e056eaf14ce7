using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace NeuronMocap.Unity.Tests.StandIn;

/// <summary>Records which of its methods the engine calls.</summary>
internal class Probe : MonoBehaviour
{
    public static List<string> Calls { get; } = [];

    /// <summary>Names of methods that throw after they have recorded the call.</summary>
    public static HashSet<string> Failing { get; } = [];

    public static void Clear()
    {
        Calls.Clear();
        Failing.Clear();
    }

    private void Awake() => Add();

    private void OnEnable() => Add();

    private void Start() => Add();

    private void FixedUpdate() => Add();

    private void Update() => Add();

    private void LateUpdate() => Add();

    private void OnDisable() => Add();

    private void OnDestroy() => Add();

    private void OnApplicationQuit() => Add();

    private void Add([CallerMemberName] string method = "")
    {
        Calls.Add($"{name}.{method}");
        if (Failing.Contains(method))
            throw new InvalidOperationException(method);
    }
}

[DefaultExecutionOrder(-10)]
internal sealed class EarlyProbe : Probe
{
}

/// <summary>Makes its first frame take long.</summary>
internal sealed class SlowProbe : MonoBehaviour
{
    public const float Seconds = 0.2f;

    public bool HasStalled { get; private set; }

    private void Update()
    {
        if (HasStalled)
            return;

        HasStalled = true;
        var watch = Stopwatch.StartNew();
        SpinWait.SpinUntil(() => watch.Elapsed.TotalSeconds > Seconds);
    }
}

[ExecuteAlways]
internal sealed class EditProbe : Probe
{
}
