using System.Globalization;
using FsCheck;
using FsCheck.Fluent;
using Microsoft.FSharp.Core;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>Checks a property on many generated cases. A failure is shrunk, and its message contains the smallest case and the seed.</summary>
internal static class Properties
{
    /// <summary>Set it to any number to run other cases than the usual ones.</summary>
    private const string SeedVariable = "NEURONMOCAP_SEED";

    // The same cases in every run, so that a build cannot fail by chance.
    private const ulong UsualSeed = 20_240_229;

    /// <summary>Asserts that a property holds for all cases.</summary>
    /// <param name="cases">Creates the cases.</param>
    /// <param name="simpler">Returns simpler cases to try after a failure, the simplest first.</param>
    /// <param name="count">The number of cases, see <see cref="Trials"/>.</param>
    /// <param name="property">Throws if the property does not hold.</param>
    public static void Hold<T>(Gen<T> cases, Func<T, IEnumerable<T>> simpler, int count, Action<T> property)
    {
        var start = new Rnd(Seed(), gamma: 1);
        Config config = Config.QuickThrowOnFailure
            .WithMaxTest(Trials.Of(count))
            .WithQuietOnSuccess(true)
            .WithReplay(FSharpOption<Replay>.Some(new Replay(start, FSharpOption<int>.None)));
        Prop.ForAll(Arb.From(cases, simpler), property).Check(config);
    }

    /// <summary>Returns lists that are shorter, or that have one element replaced by a simpler one.</summary>
    public static IEnumerable<T[]> SimplerLists<T>(T[] list, Func<T, IEnumerable<T>> simpler)
    {
        for (int size = list.Length; size > 0; size /= 2)
        {
            for (int start = 0; start < list.Length; start += size)
                yield return [.. list[..start], .. list.AsSpan(Math.Min(start + size, list.Length))];
        }

        for (int i = 0; i < list.Length; i++)
        {
            foreach (T element in simpler(list[i]))
                yield return [.. list[..i], element, .. list[(i + 1)..]];
        }
    }

    /// <summary>Returns numbers closer to zero.</summary>
    public static IEnumerable<int> SimplerNumbers(int number)
    {
        for (int step = number; step > 0; step /= 2)
            yield return number - step;
    }

    private static ulong Seed() =>
        ulong.TryParse(Environment.GetEnvironmentVariable(SeedVariable), CultureInfo.InvariantCulture, out ulong seed) ? seed : UsualSeed;
}
