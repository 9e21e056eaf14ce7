using System.IO.Compression;
using System.Security.Cryptography;
using Microsoft.AspNetCore.Http;
using Microsoft.Net.Http.Headers;

namespace NeuronMocap.Tool.View.Web;

/// <summary>One file of the page. Browsers keep it, and ask whether it has changed.</summary>
/// <param name="type">The type of the contents.</param>
/// <param name="compressed">The contents, compressed by gzip.</param>
/// <param name="neverChanges">Whether the name changes with the contents, so that browsers need not ask.</param>
internal sealed class PageFile(string type, byte[] compressed, bool neverChanges)
{
    private const string Gzip = "gzip";

    private readonly string _hash = System.Convert.ToHexString(SHA256.HashData(compressed)[..8]);

    /// <summary>Answers a GET or HEAD request, compressed if the client takes that.</summary>
    public Task SendAsync(HttpContext context)
    {
        HttpResponse response = context.Response;
        bool isCompressed = TakesGzip(context.Request);

        // The forms have different tags: they differ in their bytes.
        string tag = isCompressed ? $"\"{_hash}-{Gzip}\"" : $"\"{_hash}\"";
        response.Headers.CacheControl = neverChanges ? "public, max-age=31536000, immutable" : "no-cache";
        response.Headers.Vary = HeaderNames.AcceptEncoding;
        response.Headers.ETag = tag;
        if (HasTag(context.Request, tag))
        {
            response.StatusCode = StatusCodes.Status304NotModified;
            return Task.CompletedTask;
        }

        byte[] bytes = isCompressed ? compressed : Decompress();
        response.ContentType = type;
        response.ContentLength = bytes.Length;
        if (isCompressed)
            response.Headers.ContentEncoding = Gzip;
        return HttpMethods.IsHead(context.Request.Method) ? Task.CompletedTask : response.Body.WriteAsync(bytes, context.RequestAborted).AsTask();
    }

    // Browsers take gzip. Programs that do not are rare, and can wait.
    private byte[] Decompress()
    {
        using var stream = new GZipStream(new MemoryStream(compressed), CompressionMode.Decompress);
        using var bytes = new MemoryStream();
        stream.CopyTo(bytes);
        return bytes.ToArray();
    }

    private static bool TakesGzip(HttpRequest request)
    {
        IList<StringWithQualityHeaderValue> accepted = request.GetTypedHeaders().AcceptEncoding;
        StringWithQualityHeaderValue? match = accepted.FirstOrDefault(static each => each.Value.Equals(Gzip, StringComparison.OrdinalIgnoreCase))
            ?? accepted.FirstOrDefault(static each => each.Value == "*");
        return match is not null && match.Quality is not 0;
    }

    private static bool HasTag(HttpRequest request, string tag) =>
        request.GetTypedHeaders().IfNoneMatch.Any(each => each.Tag.Equals(tag, StringComparison.Ordinal) || each.Equals(EntityTagHeaderValue.Any));
}
