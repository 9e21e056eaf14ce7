using UnityEngine.StandIn;

namespace UnityEngine;

public static class Time
{
    private static double _now;
    private static double _unscaled;
    private static float _delta;
    private static float _unscaledDelta;
    private static float _fixedDelta = 0.02f;
    private static int _frame;

    public static float time => (float)Main(_now);

    public static double timeAsDouble => Main(_now);

    public static float unscaledTime => (float)Main(_unscaled);

    public static double unscaledTimeAsDouble => Main(_unscaled);

    public static float realtimeSinceStartup => (float)Main(_unscaled);

    public static double realtimeSinceStartupAsDouble => Main(_unscaled);

    public static float deltaTime => (float)Main(_delta * timeScale);

    public static float unscaledDeltaTime => (float)Main(_unscaledDelta);

    public static float smoothDeltaTime => deltaTime;

    public static float fixedDeltaTime
    {
        get => (float)Main(_fixedDelta);
        set => _fixedDelta = value;
    }

    public static float fixedTime => time;

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

    internal static void Restart()
    {
        (_now, _unscaled, _delta, _unscaledDelta, _frame) = (0, 0, 0, 0, 0);
        (timeScale, maximumDeltaTime, captureDeltaTime) = (1, 1 / 3f, 0);
        _fixedDelta = 0.02f;
    }

    private static double Main(double value)
    {
        MainThread.Check("Time");
        return value;
    }
}
