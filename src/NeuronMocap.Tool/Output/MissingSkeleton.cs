using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Output;

/// <summary>Explains why frames arrive, but no skeleton can be shown.</summary>
internal static class MissingSkeleton
{
    /// <summary>Explains it in a few words, and in sentences that name the setting to change.</summary>
    /// <param name="values">Values of a motion frame without a skeleton; null if no motion frame has arrived.</param>
    /// <param name="hasCalculation">Whether calculation data arrives.</param>
    /// <returns>Null if nothing has arrived yet.</returns>
    public static (string Title, string Message)? Explain(int? values, bool hasCalculation) => (values, hasCalculation) switch
    {
        ({ } count, _) => (
            "Frames without a skeleton",
            $"A frame has {count} {Quantity.Noun(count, "value")}. A skeleton of 59 bones has 180, 186, 354 or 360. The option --json shows the values."),
        (null, true) => ("Calculation data only", "The skeleton needs BVH data. Switch BVH on for this port in the server's broadcasting settings."),
        _ => null,
    };
}
