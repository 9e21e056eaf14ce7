using System.Globalization;
using NeuronMocap.Tool.View.Live;

namespace NeuronMocap.Tool.View.Actions;

/// <summary>Describes a source that cannot be examined beside its reader.</summary>
internal static class LiveDiagnosis
{
    private const string Receiving = "receiving";

    public static DiagnosisJson Of(StatusMessage status)
    {
        bool isReceiving = status.State is Receiving;
        string[] performers = [.. status.Performers.Select(Describe)];
        string summary = status.Advice.Length > 0 ? status.Advice : $"{status.Words}.";
        return new DiagnosisJson([status.Words, .. performers, summary], isReceiving ? "Receiving" : "NoData", status.Words, isReceiving, []);
    }

    private static string Describe(PerformerFigures performer) => string.Create(
        CultureInfo.InvariantCulture, $"performer {performer.Key}: {performer.Fps:0.0} frames/s, jitter {performer.Jitter:0.0} ms, {performer.Lost} lost");
}
