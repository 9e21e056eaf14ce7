using System.Reflection;
using System.Security.Cryptography;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Routing;
using Microsoft.Net.Http.Headers;

namespace NeuronMocap.Tool.View.Web;

/// <summary>The files of the page, which the build embeds into the program.</summary>
internal static class PageFiles
{
    /// <summary>Builds the page, from the folder of the repository.</summary>
    public const string BuildCommand = "dotnet build src/NeuronMocap.Tool";

    private const string Folder = "web/";
    private const string Start = "index.html";

    private static readonly (string Name, string Type)[] Files =
    [
        (Start, "text/html; charset=utf-8"),
        ("app.js", "text/javascript; charset=utf-8"),
        ("app.css", "text/css; charset=utf-8"),
        ("licenses.txt", "text/plain; charset=utf-8"),
    ];

    /// <summary>Whether the program contains the page. A build without Node does not.</summary>
    public static bool Exist => Read(Start) is not null;

    /// <summary>Whether a path is that of a file. The files are the same for everybody, and hold nothing of the stream.</summary>
    public static bool Contain(PathString path) => path == "/" || Array.Exists(Files, file => path == "/" + file.Name);

    /// <summary>Serves the files, and the start page at the root.</summary>
    public static void Map(IEndpointRouteBuilder endpoints)
    {
        foreach ((string name, string type) in Files)
        {
            byte[] bytes = Read(name) ?? [];
            string tag = $"\"{System.Convert.ToHexString(SHA256.HashData(bytes)[..8])}\"";
            RequestDelegate answer = context => bytes.Length > 0 ? SendAsync(context, bytes, type, tag) : SayMissingAsync(context);
            endpoints.MapMethods("/" + name, ["GET", "HEAD"], answer);
            if (name is Start)
                endpoints.MapMethods("/", ["GET", "HEAD"], answer);
        }
    }

    private static Task SendAsync(HttpContext context, byte[] bytes, string type, string tag)
    {
        context.Response.Headers.CacheControl = "no-cache";
        context.Response.Headers.ETag = tag;
        if (context.Request.Headers.IfNoneMatch.ToString().Equals(tag, StringComparison.Ordinal))
        {
            context.Response.StatusCode = StatusCodes.Status304NotModified;
            return Task.CompletedTask;
        }

        context.Response.Headers[HeaderNames.ContentType] = type;
        context.Response.ContentLength = bytes.Length;
        return HttpMethods.IsHead(context.Request.Method)
            ? Task.CompletedTask
            : context.Response.Body.WriteAsync(bytes, context.RequestAborted).AsTask();
    }

    private static Task SayMissingAsync(HttpContext context)
    {
        context.Response.StatusCode = StatusCodes.Status404NotFound;
        context.Response.ContentType = "text/plain; charset=utf-8";
        return context.Response.WriteAsync($"This build of the program does not contain the page. Install Node.js, then run: {BuildCommand}\n", context.RequestAborted);
    }

    private static byte[]? Read(string name)
    {
        using Stream? stream = Assembly.GetExecutingAssembly().GetManifestResourceStream(Folder + name);
        if (stream is null)
            return null;

        byte[] bytes = new byte[stream.Length];
        stream.ReadExactly(bytes);
        return bytes;
    }
}
