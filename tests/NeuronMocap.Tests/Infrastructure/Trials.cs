namespace NeuronMocap.Tests.Infrastructure;

/// <summary>How many random cases a test tries: all on the usual build, and a fifth on the others, which run the same code on other runtimes.</summary>
internal static class Trials
{
#if OTHER_BUILD
    private const int Part = 5;
#else
    private const int Part = 1;
#endif

    public static int Of(int count) => (count + Part - 1) / Part;

    /// <summary>Returns how often something must happen in these cases. Few cases hold more of it by chance, or less.</summary>
    public static int Fewest(int count) => Part == 1 ? count : count / (2 * Part);
}
