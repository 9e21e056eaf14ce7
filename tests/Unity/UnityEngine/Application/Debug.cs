using UnityEngine.StandIn;

namespace UnityEngine;

public static class Debug
{
    public static ILogger unityLogger { get; } = new Logger();

    public static bool isDebugBuild => true;

    public static bool developerConsoleVisible { get; set; }

    public static void Log(object? message) => ConsoleLog.Add(LogType.Log, message, null);

    public static void Log(object? message, Object? context) => ConsoleLog.Add(LogType.Log, message, context);

    public static void LogFormat(string format, params object[] args) => Log(Format(format, args));

    public static void LogWarning(object? message) => ConsoleLog.Add(LogType.Warning, message, null);

    public static void LogWarning(object? message, Object? context) => ConsoleLog.Add(LogType.Warning, message, context);

    public static void LogWarningFormat(string format, params object[] args) => LogWarning(Format(format, args));

    public static void LogError(object? message) => ConsoleLog.Add(LogType.Error, message, null);

    public static void LogError(object? message, Object? context) => ConsoleLog.Add(LogType.Error, message, context);

    public static void LogErrorFormat(string format, params object[] args) => LogError(Format(format, args));

    public static void LogException(Exception exception) => LogException(exception, null);

    public static void LogException(Exception exception, Object? context) => ConsoleLog.Add(LogType.Exception, exception, context);

    [System.Diagnostics.Conditional("UNITY_ASSERTIONS")]
    public static void Assert(bool condition) => Assert(condition, "Assertion failed");

    [System.Diagnostics.Conditional("UNITY_ASSERTIONS")]
    public static void Assert(bool condition, string message)
    {
        if (!condition)
            ConsoleLog.Add(LogType.Assert, message, null);
    }

    public static void DrawLine(Vector3 start, Vector3 end) => DrawLine(start, end, Color.white);

    public static void DrawLine(Vector3 start, Vector3 end, Color color) => DrawLine(start, end, color, 0);

    public static void DrawLine(Vector3 start, Vector3 end, Color color, float duration) => GizmoLog.Add("Line", color, start, end);

    public static void DrawRay(Vector3 start, Vector3 dir, Color color) => DrawLine(start, start + dir, color);

    private static string Format(string format, object[] args) => string.Format(System.Globalization.CultureInfo.InvariantCulture, format, args);
}

public enum LogType
{
    Error,
    Assert,
    Warning,
    Log,
    Exception,
}

public interface ILogger
{
    bool logEnabled { get; set; }

    void Log(LogType logType, object message);
}

public class Logger : ILogger
{
    public bool logEnabled { get; set; } = true;

    public void Log(LogType logType, object message)
    {
        if (logEnabled)
            ConsoleLog.Add(logType, message, null);
    }
}
