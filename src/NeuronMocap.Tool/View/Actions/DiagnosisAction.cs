using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Routing;
using NeuronMocap.Diagnostics;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Actions;

/// <summary>POST /api/diagnose: examines the stream as the verb diagnose does.</summary>
/// <param name="source">The source.</param>
/// <param name="options">The options of a reader of the source.</param>
/// <param name="describe">Describes what is known of a source that only one reader can have.</param>
internal sealed class DiagnosisAction(Source source, NeuronReaderOptions options, Func<DiagnosisJson> describe) : IViewPart
{
    private readonly SemaphoreSlim _running = new(1);

    public void Map(IEndpointRouteBuilder endpoints) => endpoints.MapPost("/api/diagnose", HandleAsync);

    public ValueTask DisposeAsync()
    {
        _running.Dispose();
        return ValueTask.CompletedTask;
    }

    private async Task HandleAsync(HttpContext context)
    {
        // A second socket cannot have the port, and a broker has no steps to examine.
        if (source.Kind is not (SourceKind.Tcp or SourceKind.Demo or SourceKind.WebSocket))
        {
            await ApiJson.WriteAsync(context, describe());
            return;
        }

        if (!await _running.WaitAsync(TimeSpan.Zero))
            throw ApiException.Conflict("Another diagnosis is running. It ends within 10 seconds.");

        try
        {
            StreamDiagnosis diagnosis = await NeuronDiagnostics.DiagnoseAsync(options, new DiagnosisOptions(), progress: null, context.RequestAborted);
            await ApiJson.WriteAsync(context, DiagnosisJson.Of(diagnosis));
        }
        finally
        {
            _running.Release();
        }
    }
}

/// <summary>The result of a diagnosis.</summary>
/// <param name="Lines">What was found, line by line. The last one is the summary.</param>
/// <param name="Verdict">The name of the verdict, as in diagnose --json.</param>
/// <param name="Title">The verdict in a few words.</param>
/// <param name="Receiving">Whether frames arrive.</param>
/// <param name="Steps">The steps, for a table; empty if nothing was examined.</param>
internal sealed record DiagnosisJson(IReadOnlyList<string> Lines, string Verdict, string Title, bool Receiving, IReadOnlyList<DiagnosisStepJson> Steps)
{
    public static DiagnosisJson Of(StreamDiagnosis diagnosis)
    {
        DiagnosisStepJson[] steps = [.. diagnosis.Steps.Select(static step => new DiagnosisStepJson(step.Name, WordOf(step.Outcome), Translate(step.Detail)))];
        return new DiagnosisJson(
            [.. steps.Select(static step => $"{step.Outcome}: {step.Name}: {step.Detail}"), Translate(diagnosis.Summary)],
            diagnosis.Verdict.ToString(),
            diagnosis.Title,
            diagnosis.IsReceiving,
            steps);
    }

    private static string WordOf(StepOutcome outcome) => outcome switch
    {
        StepOutcome.Ok => "ok",
        StepOutcome.Warning => "warning",
        _ => "failed",
    };

    private static string Translate(string text) => TerminalText.Clean(OptionNames.Translate(text));
}

/// <summary>A step of a diagnosis.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Outcome">"ok", "warning" or "failed".</param>
/// <param name="Detail">The observation.</param>
internal sealed record DiagnosisStepJson(string Name, string Outcome, string Detail);
