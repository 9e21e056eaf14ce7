namespace NeuronMocap.Tests.Infrastructure;

/// <summary>How many random cases a test tries.</summary>
internal static class Trials
{
    /// <summary>Returns the number of cases: all of them on the usual build, and a fifth on the others, which run the same code on other runtimes.</summary>
    public static int Of(int count) =>
#if OTHER_BUILD
        (count + 4) / 5;
#else
        count;
#endif
}
