using System.Globalization;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Routing;
using NeuronMocap.Gltf;
using NeuronMocap.Tool.View.Performers;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Figures;

/// <summary>GET /api/performers/{key}/figure.glb: the figure with a performer's body.</summary>
/// <param name="find">Finds a performer.</param>
internal sealed class FigureFiles(Func<PerformerKey, Performer?> find) : IViewPart
{
    public void Map(IEndpointRouteBuilder endpoints) => endpoints.MapGet("/api/performers/{key}/figure.glb", HandleAsync);

    public ValueTask DisposeAsync() => ValueTask.CompletedTask;

    private Task HandleAsync(HttpContext context)
    {
        if (!PerformerKey.TryParse(context.Request.RouteValues["key"] as string, out PerformerKey key) || find(key) is not { } performer)
            throw ApiException.NotFound("There is no such performer.");

        return SendAsync(context, performer);
    }

    /// <summary>Answers a request with the figure of a performer.</summary>
    public static Task SendAsync(HttpContext context, Performer performer)
    {
        byte[] glb = GlbWriter.CreateFigure(performer.Body, performer.Name, ColourOf(performer));
        context.Response.ContentType = "model/gltf-binary";
        context.Response.ContentLength = glb.Length;
        return context.Response.Body.WriteAsync(glb, context.RequestAborted).AsTask();
    }

    private static int ColourOf(Performer performer) => int.Parse(performer.Colour.AsSpan(1), NumberStyles.HexNumber, CultureInfo.InvariantCulture);
}
