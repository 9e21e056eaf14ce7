using System.Buffers;
using System.Reflection;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Routing;

namespace NeuronMocap.Tool.View.Web;

/// <summary>The files of the page, which the build compresses and embeds into the program.</summary>
internal static class PageFiles
{
    /// <summary>Builds the page, from the folder of the repository.</summary>
    public const string BuildCommand = "dotnet build src/NeuronMocap.Tool";

    private const string Folder = "web/";
    private const string Compressed = ".gz";
    private const string Start = "index.html";

    private static readonly SearchValues<char> HashLetters = SearchValues.Create("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789");

    private static readonly HashSet<string> Names = [.. FindNames()];

    /// <summary>Whether the program contains the page. A build without Node does not.</summary>
    public static bool Exist => Names.Contains(Start);

    /// <summary>Whether a path is that of a file. The files are the same for everybody, and hold nothing of the stream.</summary>
    public static bool Contain(PathString path) => path == "/" || (path.Value is ['/', .. var name] && (name is Start || Names.Contains(name)));

    /// <summary>Serves the files, and the start page at the root.</summary>
    public static void Map(IEndpointRouteBuilder endpoints)
    {
        foreach (string name in Names)
            MapFile("/" + name, name);

        MapFile("/", Start);
        if (!Exist)
            MapFile("/" + Start, Start);

        void MapFile(string path, string name)
        {
            var file = new Lazy<PageFile?>(() => Read(name));
            endpoints.MapMethods(path, ["GET", "HEAD"], (RequestDelegate)(context => file.Value?.SendAsync(context) ?? SayMissingAsync(context)));
        }
    }

    private static Task SayMissingAsync(HttpContext context)
    {
        context.Response.StatusCode = StatusCodes.Status404NotFound;
        context.Response.ContentType = "text/plain; charset=utf-8";
        return context.Response.WriteAsync($"This build of the program does not contain the page. Install Node 20 or later, then run: {BuildCommand}\n", context.RequestAborted);
    }

    private static PageFile? Read(string name)
    {
        using Stream? stream = Assembly.GetExecutingAssembly().GetManifestResourceStream(Folder + name + Compressed);
        if (stream is null)
            return null;

        byte[] bytes = new byte[stream.Length];
        stream.ReadExactly(bytes);
        return new PageFile(TypeOf(name), bytes, HasHash(name));
    }

    private static IEnumerable<string> FindNames() => Assembly.GetExecutingAssembly().GetManifestResourceNames()
        .Where(static name => name.StartsWith(Folder, StringComparison.Ordinal) && name.EndsWith(Compressed, StringComparison.Ordinal))
        .Select(static name => name[Folder.Length..^Compressed.Length]);

    private static string TypeOf(string name) => Path.GetExtension(name) switch
    {
        ".html" => "text/html; charset=utf-8",
        ".js" => "text/javascript; charset=utf-8",
        ".css" => "text/css; charset=utf-8",
        _ => "text/plain; charset=utf-8",
    };

    // The build gives such names to the scripts that app.js loads: main-WZ3J47N5.js.
    private static bool HasHash(string name)
    {
        const int Letters = 8;
        string stem = Path.GetFileNameWithoutExtension(name);
        return name.EndsWith(".js", StringComparison.Ordinal) && stem.Length > Letters && stem[^(Letters + 1)] == '-'
            && !stem.AsSpan(stem.Length - Letters).ContainsAnyExcept(HashLetters);
    }
}
