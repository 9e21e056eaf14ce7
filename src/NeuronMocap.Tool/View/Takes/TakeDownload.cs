using System.Collections.Immutable;
using Microsoft.AspNetCore.Http;
using Microsoft.Net.Http.Headers;
using NeuronMocap.Tool.Convert;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.View.Performers;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>Sends takes as files of another kind, made by the code of convert.</summary>
/// <remarks>convert holds a take in memory, so only one runs at a time.</remarks>
internal sealed class TakeDownload(ScratchFolder scratch) : IDisposable
{
    private const string Closed = "The take was closed.";

    private static readonly string[] Formats = ["bvh", "nmrec", "glb", "csv", "calc"];

    private readonly SemaphoreSlim _turn = new(1);

    public async Task SendAsync(HttpContext context, Take take)
    {
        string format = context.Request.Query["format"].ToString().ToLowerInvariant();
        string extension = "." + format;
        if (!Formats.Contains(format) || FileKinds.OfName("take" + extension) is not { } kind)
            throw ApiException.BadRequest($"format must be one of these: {string.Join(", ", Formats)}.");

        string wanted = context.Request.Query["performer"].ToString();
        long from = TakeRequest.GetTime(context, "from", usual: -1);
        long to = TakeRequest.GetTime(context, "to", usual: -1);
        bool isWhole = from < 0 && to < 0;
        string name = Path.GetFileNameWithoutExtension(take.Name) + extension;
        if (isWhole && kind == take.Kind && wanted.Length == 0)
        {
            await SendOriginalAsync(context, take, name);
            return;
        }

        await RequireMotionAsync(take, context.RequestAborted);
        TakePerformer performer = take.Find(wanted) ?? throw ApiException.NotFound("The take has no such performer.");
        if (isWhole && kind == take.Kind)
        {
            await SendOriginalAsync(context, take, name);
            return;
        }

        bool hasOneAvatar = HasOneAvatar(kind, wanted);
        (from, to) = FindArrival(hasOneAvatar ? [performer] : take.Performers, from, to);
        PerformerKey? source = take.Kind is FileKind.Recording or FileKind.Raw && hasOneAvatar ? performer.Source : null;
        var settings = new FileSettings(take.Path, Path.Combine(scratch.Path, ScratchFolder.NewName() + extension))
        {
            InputName = take.Name,
            InputOrder = take.RotationOrder,
            Avatar = source?.Avatar,
            Sender = source?.Sender,
            From = SecondsOf(from),
            To = SecondsOf(to),
        };
        try
        {
            await ConvertAsync(settings, take, name, context.RequestAborted);
            await SendFileAsync(context, settings.Output!, name);
        }
        finally
        {
            File.Delete(settings.Output!);
        }
    }

    public void Dispose() => _turn.Dispose();

    // A take that is still being read may have no performer yet.
    private static async Task RequireMotionAsync(Take take, CancellationToken cancellationToken)
    {
        if (HasMotion(take))
            return;

        await take.Completion.WaitAsync(cancellationToken);
        if (take.Closed.IsCancellationRequested)
            throw ApiException.NotFound(Closed);
        if (!HasMotion(take))
            throw ApiException.Conflict($"'{take.Name}' holds no frames of motion.");
    }

    private static bool HasMotion(Take take) => take.Performers.Any(static performer => performer.Frames > 0);

    // Frames of a recording have the times at which they were sent, and convert selects by arrival. Negative times are no limits.
    private static (long From, long To) FindArrival(ImmutableArray<TakePerformer> performers, long from, long to)
    {
        TimeStretch[] arrivals = [.. performers.Select(performer => performer.Times.FindArrival(from, to))];
        return (from < 0 ? from : arrivals.Min(static arrival => arrival.From), to < 0 ? to : arrivals.Max(static arrival => arrival.To));
    }

    // The page knows the times of frames to a microsecond. A frame at the in point belongs to the part.
    private static double? SecondsOf(long microseconds) => microseconds < 0 ? null : Math.Max(0, microseconds - 1) / 1e6;

    // Figures and tables hold all performers, unless one is chosen.
    private static bool HasOneAvatar(FileKind kind, string wanted) => kind switch
    {
        FileKind.Recording or FileKind.Raw => false,
        FileKind.Glb or FileKind.Csv => wanted.Length > 0,
        _ => true,
    };

    private async Task ConvertAsync(FileSettings settings, Take take, string name, CancellationToken cancellationToken)
    {
        await _turn.WaitAsync(cancellationToken);
        try
        {
            using var stop = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken, take.Closed);
            using var messages = new StringWriter();
            int code = await new ConvertTool(settings, new StandardStreams(Stream.Null, messages, IsTerminal: false)).RunAsync(stop.Token);
            stop.Token.ThrowIfCancellationRequested();
            if (code != ToolCommand.Done)
                throw ApiException.Conflict(Describe(messages.ToString(), settings, take, name));
        }
        catch (OperationCanceledException) when (!cancellationToken.IsCancellationRequested)
        {
            throw ApiException.NotFound(Closed);
        }
        finally
        {
            _turn.Release();
        }
    }

    private static string Describe(string messages, FileSettings settings, Take take, string name) => messages.Trim()
        .Replace($"{ToolCommand.Name}: ", "", StringComparison.Ordinal)
        .Replace(settings.Input, take.Name, StringComparison.Ordinal)
        .Replace(settings.Output!, name, StringComparison.Ordinal);

    // The user may have moved or deleted the file since the take was read.
    private static async Task SendOriginalAsync(HttpContext context, Take take, string name)
    {
        try
        {
            await SendFileAsync(context, take.Path, name);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException && !context.Response.HasStarted)
        {
            context.Response.Clear();
            throw ApiException.NotFound(FileFault.OfReading(exception, take.Name));
        }
    }

    private static Task SendFileAsync(HttpContext context, string path, string name)
    {
        context.Response.ContentType = "application/octet-stream";
        var disposition = new ContentDispositionHeaderValue("attachment");
        disposition.SetHttpFileName(name);
        context.Response.Headers.ContentDisposition = disposition.ToString();
        return context.Response.SendFileAsync(path, context.RequestAborted);
    }
}
