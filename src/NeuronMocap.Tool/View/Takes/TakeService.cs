using System.Buffers.Binary;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Routing;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.View.Control;
using NeuronMocap.Tool.View.Figures;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>The addresses below /api/takes.</summary>
/// <param name="scratch">The folder for uploads and temporary files.</param>
/// <param name="hub">Tells pages of new takes.</param>
/// <param name="uploadMegabytes">The largest upload.</param>
/// <param name="run">The start of the takes' ids.</param>
internal sealed class TakeService(ScratchFolder scratch, ControlHub hub, int uploadMegabytes, string run) : ITakeLibrary
{
    private const int MostFrames = 4096; // in an answer
    private const int MostPoints = 10_000;
    private const int FramesPerRead = 64;

    private const int RoomOfUpload = 4; // times the largest upload

    private readonly TakeLibrary _library = new(scratch, run, RoomOfUpload * uploadMegabytes * BodyLimit.Megabyte);
    private readonly TakeDownload _download = new(scratch);

    public Task<string> OpenAsync(string path, RotationOrder? order, CancellationToken cancellationToken) =>
        Task.Run(() => Open(path, Path.GetFileName(path), isUpload: false, order).Id, cancellationToken);

    public Task<TakePerformer?> FindPerformerAsync(string key, CancellationToken cancellationToken) => _library.FindPerformerAsync(key, cancellationToken);

    public void Map(IEndpointRouteBuilder endpoints)
    {
        endpoints.MapPost("/api/takes", UploadAsync).WithMetadata(new BodyLimit(uploadMegabytes * BodyLimit.Megabyte));
        endpoints.MapGet("/api/takes/{id}", context => ApiJson.WriteAsync(context, TakeJson.Of(Find(context))));
        endpoints.MapGet("/api/takes/{id}/times", SendTimesAsync);
        endpoints.MapGet("/api/takes/{id}/poses", SendPosesAsync);
        endpoints.MapGet("/api/takes/{id}/contacts", SendContactsAsync);
        endpoints.MapGet("/api/takes/{id}/curves", SendCurveAsync);
        endpoints.MapGet("/api/takes/{id}/performers/{key}/figure.glb", SendFigureAsync);
        endpoints.MapGet("/api/takes/{id}/download", async context => await _download.SendAsync(context, await FindKnownAsync(context)));
    }

    public ValueTask DisposeAsync()
    {
        _library.Dispose();
        _download.Dispose();
        return ValueTask.CompletedTask;
    }

    private async Task UploadAsync(HttpContext context)
    {
        string name = context.Request.Query["name"].ToString();
        string path = await scratch.SaveAsync(context.Request.Body, context.RequestAborted);
        Take take;
        try
        {
            take = await Task.Run(() => Open(path, TakeName.Clean(name), isUpload: true, order: null));
        }
        catch
        {
            scratch.Delete(path);
            throw;
        }

        hub.Send(new TakeMessage(take.Id));
        await ApiJson.WriteAsync(context, new { id = take.Id });
    }

    private Take Open(string path, string name, bool isUpload, RotationOrder? order)
    {
        try
        {
            return _library.Open(path, name, isUpload, order);
        }
        catch (NeuronException exception)
        {
            throw ApiException.BadRequest(exception.Message);
        }
    }

    private Take Find(HttpContext context) =>
        _library.Find((string)context.Request.RouteValues["id"]!) ?? throw ApiException.NotFound("This take is not open any more. Drop its file on the page again.");

    private async Task<Take> FindKnownAsync(HttpContext context)
    {
        Take take = Find(context);
        await take.WaitUntilKnownAsync(context.RequestAborted);
        return take;
    }

    private async Task<TakePerformer> FindPerformerAsync(HttpContext context) => FindPerformer(context, await FindKnownAsync(context));

    private static TakePerformer FindPerformer(HttpContext context, Take take) =>
        take.Find(context.Request.Query["performer"]) ?? throw ApiException.NotFound("The take has no such performer.");

    private async Task SendTimesAsync(HttpContext context)
    {
        Take take = await FindKnownAsync(context);
        await ApiJson.WriteAsync(context, TakeTimesJson.Of(take, FindPerformer(context, take)));
    }

    private async Task SendPosesAsync(HttpContext context)
    {
        TakePerformer performer = await FindPerformerAsync(context);
        long next = TakeRequest.GetNumber(context, "from", usual: 0, least: 0, most: long.MaxValue / 2);
        long end = Math.Min(performer.Frames, next + TakeRequest.GetNumber(context, "count", usual: 1, least: 1, MostFrames));
        int size = performer.Poses.RecordSize;
        context.Response.ContentType = "application/octet-stream";
        context.Response.ContentLength = Math.Max(0, end - next) * (sizeof(uint) + size);
        byte[] poses = new byte[FramesPerRead * size];
        byte[] answer = new byte[FramesPerRead * (sizeof(uint) + size)];
        while (next < end)
        {
            int count = Read(performer, next, poses.AsSpan(0, (int)Math.Min(end - next, FramesPerRead) * size));
            for (int i = 0; i < count; i++)
            {
                Span<byte> entry = answer.AsSpan(i * (sizeof(uint) + size));
                BinaryPrimitives.WriteUInt32LittleEndian(entry, (uint)size);
                poses.AsSpan(i * size, size).CopyTo(entry[sizeof(uint)..]);
            }

            await context.Response.Body.WriteAsync(answer.AsMemory(0, count * (sizeof(uint) + size)), context.RequestAborted);
            next += count;
        }
    }

    private static int Read(TakePerformer performer, long first, Span<byte> poses)
    {
        try
        {
            return performer.Poses.Read(first, poses);
        }
        catch (ObjectDisposedException)
        {
            throw ApiException.NotFound("The take was closed.");
        }
    }

    private async Task SendContactsAsync(HttpContext context)
    {
        var (left, right) = (await FindPerformerAsync(context)).GetContacts();
        await ApiJson.WriteAsync(context, new { left = TakePerformerJson.Milliseconds(left), right = TakePerformerJson.Milliseconds(right) });
    }

    private async Task SendCurveAsync(HttpContext context)
    {
        TakePerformer performer = await FindPerformerAsync(context);
        string name = context.Request.Query["bone"].ToString();
        if (!BoneHierarchy.TryFind(name, performer.Body.Variant, out Bone bone))
            throw ApiException.BadRequest("bone must be the name of a bone of the performer.");

        var quantity = TakeRequest.GetName<CurveQuantity>(context, "quantity");
        int points = (int)TakeRequest.GetNumber(context, "points", usual: 1000, least: 1, MostPoints);
        long from = TakeRequest.GetTime(context, "from", performer.Frames == 0 ? 0 : performer.Times.Start);
        long to = TakeRequest.GetTime(context, "to", performer.Frames == 0 ? 0 : performer.Times.End);
        if (to < from)
            throw ApiException.BadRequest("to must not be before from.");

        TakeCurve curve;
        try
        {
            curve = await Task.Run(() => TakeCurve.Of(performer, bone, quantity, from, to, points));
        }
        catch (ObjectDisposedException)
        {
            throw ApiException.NotFound("The take was closed.");
        }

        await ApiJson.WriteAsync(context, new { unit = TakeCurve.Units[(int)quantity], times = curve.Times, min = Known(curve.Lowest), max = Known(curve.Highest) });
    }

    private async Task SendFigureAsync(HttpContext context)
    {
        Take take = await FindKnownAsync(context);
        TakePerformer performer = take.Find((string)context.Request.RouteValues["key"]!) ?? throw ApiException.NotFound("The take has no such performer.");
        await FigureFiles.SendAsync(context, TakePerformerJson.Describe(performer));
    }

    // JSON has no word for what is not a number.
    private static float?[] Known(float[] values) => Array.ConvertAll(values, static value => float.IsFinite(value) ? value : (float?)null);
}
