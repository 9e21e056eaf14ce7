using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine.StandIn;

namespace UnityEngine.TestTools;

public static class LogAssert
{
    private static readonly List<(LogType Type, Func<string, bool> IsWanted, string Text)> _expected = [];

    public static bool ignoreFailingMessages { get; set; }

    public static void Expect(LogType type, string message) => _expected.Add((type, text => text == message, message));

    public static void Expect(LogType type, Regex message) => _expected.Add((type, message.IsMatch, message.ToString()));

    public static void NoUnexpectedReceived() => Check(isEnd: false, everything: true);

    /// <summary>Unexpected errors fail a test, and so do expected errors that did not occur.</summary>
    internal static void Check(bool isEnd, bool everything)
    {
        foreach ((LogType type, Func<string, bool> isWanted, string text) in _expected.ToArray())
        {
            LogEntry? found = ConsoleLog.Entries.FirstOrDefault(entry => entry.Type == type && isWanted(entry.Message));
            if (found is not null)
                ConsoleLog.Remove(found);
            else if (isEnd)
                Assert.Fail($"Expected log did not appear: [{type}] {text}");
            else
                continue;

            _expected.Remove((type, isWanted, text));
        }

        LogEntry? unexpected = ConsoleLog.Entries.FirstOrDefault(entry => everything || entry.Type is not (LogType.Log or LogType.Warning));
        if (unexpected is not null && !ignoreFailingMessages)
            Assert.Fail($"Unhandled log message: {unexpected}");
    }

    internal static void Clear()
    {
        _expected.Clear();
        ignoreFailingMessages = false;
    }
}
