using Microsoft.AspNetCore.Http;
using Microsoft.Net.Http.Headers;
using NeuronMocap.Tool.Convert;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>Sends takes as files of another kind, made by the code of convert.</summary>
/// <remarks>convert holds a take in memory, so only one runs at a time.</remarks>
internal sealed class TakeDownload(ScratchFolder scratch)
{
    private static readonly string[] Formats = ["bvh", "nmrec", "glb", "csv", "calc"];

    private readonly SemaphoreSlim _turn = new(1);
    private int _number;

    public async Task SendAsync(HttpContext context, Take take)
    {
        string format = context.Request.Query["format"].ToString().ToLowerInvariant();
        string extension = "." + format;
        if (!Formats.Contains(format) || FileKinds.OfName("take" + extension) is not { } kind)
            throw ApiException.BadRequest($"format must be one of these: {string.Join(", ", Formats)}.");

        TakePerformer? performer = take.Find(context.Request.Query["performer"]) ?? throw ApiException.NotFound("The take has no such performer.");
        long from = TakeRequest.GetTime(context, "from", usual: -1);
        long to = TakeRequest.GetTime(context, "to", usual: -1);
        bool isWhole = from < 0 && to < 0;
        string name = Path.GetFileNameWithoutExtension(take.Name) + extension;
        if (isWhole && kind == take.Kind)
        {
            await SendFileAsync(context, take.Path, name);
            return;
        }

        var settings = new FileSettings(take.Path, Path.Combine(scratch.Path, $"download{Interlocked.Increment(ref _number)}{extension}"))
        {
            InputName = take.Name,
            Avatar = take.Kind is FileKind.Recording or FileKind.Raw && kind is not (FileKind.Recording or FileKind.Raw) ? performer.AvatarIndex : null,
            From = from < 0 ? null : from / 1e6,
            To = to < 0 ? null : to / 1e6,
        };
        try
        {
            await ConvertAsync(settings, take, context.RequestAborted);
            await SendFileAsync(context, settings.Output!, name);
        }
        finally
        {
            File.Delete(settings.Output!);
        }
    }

    private async Task ConvertAsync(FileSettings settings, Take take, CancellationToken cancellationToken)
    {
        await _turn.WaitAsync(cancellationToken);
        try
        {
            using var stop = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken, take.Closed);
            using var messages = new StringWriter();
            int code = await new ConvertTool(settings, new StandardStreams(Stream.Null, messages, IsTerminal: false)).RunAsync(stop.Token);
            stop.Token.ThrowIfCancellationRequested();
            if (code != ToolCommand.Done)
                throw ApiException.Conflict(Describe(messages.ToString(), settings, take));
        }
        catch (OperationCanceledException) when (!cancellationToken.IsCancellationRequested)
        {
            throw ApiException.NotFound("The take was closed.");
        }
        finally
        {
            _turn.Release();
        }
    }

    private static string Describe(string messages, FileSettings settings, Take take) => messages.Trim()
        .Replace($"{ToolCommand.Name}: ", "", StringComparison.Ordinal)
        .Replace(settings.Input, take.Name, StringComparison.Ordinal)
        .Replace(settings.Output!, Path.GetFileName(settings.Output!), StringComparison.Ordinal);

    private static Task SendFileAsync(HttpContext context, string path, string name)
    {
        context.Response.ContentType = "application/octet-stream";
        var disposition = new ContentDispositionHeaderValue("attachment");
        disposition.SetHttpFileName(name);
        context.Response.Headers.ContentDisposition = disposition.ToString();
        return context.Response.SendFileAsync(path, context.RequestAborted);
    }
}
