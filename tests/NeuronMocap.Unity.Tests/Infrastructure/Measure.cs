using System.Reflection;

namespace NeuronMocap.Unity.Tests.Infrastructure;

/// <summary>Measurements of the engine for tests of figures and recorders.</summary>
internal static class Measure
{
    /// <summary>The number of live objects, both assets and objects of the scene.</summary>
    public static int LiveObjects => World.Objects.Count;

    /// <summary>Returns bytes that a script's own callbacks allocate, per frame, while the engine runs.</summary>
    public static long BytesPerFrame(PlayerLoop loop, MonoBehaviour script, params string[] callbacks)
    {
        Action[] calls = [.. callbacks.Select(name => ScriptCallbacks.Of(script.GetType()).Bind(script, name)
            ?? throw new InvalidOperationException($"There is no {name}."))];
        Run(calls, loop, 120);
        return Allocations.Least(() => Run(calls, loop, 60));
    }

    /// <summary>Returns the value of a public or private field.</summary>
    public static object? Field(object item, string name) =>
        item.GetType().GetField(name, BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public)!.GetValue(item);

    private static long Run(Action[] calls, PlayerLoop loop, int frames)
    {
        long bytes = 0;
        for (int i = 0; i < frames; i++)
        {
            loop.Frame();
            long before = GC.GetAllocatedBytesForCurrentThread();
            foreach (Action call in calls)
                call();

            bytes += GC.GetAllocatedBytesForCurrentThread() - before;
        }

        return bytes;
    }
}
