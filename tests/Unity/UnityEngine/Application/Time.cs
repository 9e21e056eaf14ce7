using UnityEngine.StandIn;

namespace UnityEngine;

public static class Time
{
    private static double _now;
    private static double _unscaled;
    private static double _fixed;
    private static float _delta;
    private static float _unscaledDelta;
    private static float _fixedDelta = 0.02f;
    private static int _frame;

    // In FixedUpdate, times and intervals are those of the physics step.
    public static bool inFixedTimeStep { get; private set; }

    public static float time => (float)timeAsDouble;

    public static double timeAsDouble => Main(inFixedTimeStep ? _fixed : _now);

    public static float unscaledTime => (float)Main(_unscaled);

    public static double unscaledTimeAsDouble => Main(_unscaled);

    public static float realtimeSinceStartup => (float)Main(_unscaled);

    public static double realtimeSinceStartupAsDouble => Main(_unscaled);

    public static float deltaTime => (float)Main(inFixedTimeStep ? _fixedDelta : _delta * timeScale);

    public static float unscaledDeltaTime => (float)Main(inFixedTimeStep ? fixedUnscaledDeltaTime : _unscaledDelta);

    public static float fixedUnscaledDeltaTime => (float)Main(timeScale > 0 ? _fixedDelta / timeScale : _fixedDelta);

    public static float smoothDeltaTime => deltaTime;

    public static float fixedDeltaTime
    {
        get => (float)Main(_fixedDelta);
        set => _fixedDelta = value;
    }

    public static float fixedTime => (float)fixedTimeAsDouble;

    public static double fixedTimeAsDouble => Main(_fixed);

    public static float timeSinceLevelLoad => time;

    public static float timeScale { get; set; } = 1;

    public static float maximumDeltaTime { get; set; } = 1 / 3f;

    /// <summary>Above 0, each frame lasts so many seconds of the game, whatever its real duration.</summary>
    public static float captureDeltaTime { get; set; }

    public static int captureFramerate
    {
        get => captureDeltaTime > 0 ? Mathf.RoundToInt(1 / captureDeltaTime) : 0;
        set => captureDeltaTime = value > 0 ? 1f / value : 0;
    }

    public static int frameCount => (int)Main(_frame);

    public static int renderedFrameCount => frameCount;

    internal static void Advance(float seconds)
    {
        _delta = captureDeltaTime > 0 ? captureDeltaTime : Math.Min(seconds, maximumDeltaTime);
        _unscaledDelta = seconds;
        _now += _delta * timeScale;
        _unscaled += seconds;
        _frame++;
    }

    internal static void BeginFixedStep()
    {
        _fixed += _fixedDelta;
        inFixedTimeStep = true;
    }

    internal static void EndFixedStep() => inFixedTimeStep = false;

    internal static void Restart()
    {
        (_now, _unscaled, _fixed, _delta, _unscaledDelta, _frame) = (0, 0, 0, 0, 0, 0);
        (timeScale, maximumDeltaTime, captureDeltaTime) = (1, 1 / 3f, 0);
        inFixedTimeStep = false;
        _fixedDelta = 0.02f;
    }

    private static double Main(double value)
    {
        MainThread.Check("Time");
        return value;
    }
}
