using System.Text;
using System.Text.RegularExpressions;
using NeuronMocap.Native.Tests.Infrastructure;

namespace NeuronMocap.Native.Tests.Surface;

/// <summary>The declarations of the headers, and the symbols of the library.</summary>
internal static partial class CSurface
{
    /// <summary>Returns declarations and macros of both headers, in their order, without comments.</summary>
    public static async Task<IReadOnlyList<string>> DeclarationsAsync(string generation)
    {
        (int code, string output, string errors) = await SystemTool.RunAsync(
            "gcc", "-E", "-dD", "-std=c99", "-DNEURONDATAREADER_" + generation, Path.Combine(NativeFiles.Headers, "NeuronDataReader.h"));
        Assert.Equal((0, ""), (code, errors));
        return [.. Statements(OwnLines(output.Split('\n'))).Where(static statement => !statement.Contains("_differs[", StringComparison.Ordinal))];
    }

    public static IEnumerable<string> Functions(IEnumerable<string> declarations) =>
        declarations.Where(static line => !line.StartsWith("typedef", StringComparison.Ordinal) && !line.StartsWith("static", StringComparison.Ordinal))
            .Select(static line => Function().Match(line))
            .Where(static match => match.Success)
            .Select(static match => match.Groups["name"].Value);

    /// <summary>Returns names of the library's dynamic symbols, without their versions.</summary>
    public static async Task<string[]> ExportsAsync()
    {
        (int code, string output, string errors) = await SystemTool.RunAsync("nm", "-D", "--defined-only", "--format=posix", NativeFiles.Library);
        Assert.Equal((0, ""), (code, errors));

        // A symbol of kind A is the name of a version.
        return
        [
            .. output.Split('\n', StringSplitOptions.RemoveEmptyEntries)
                .Select(static line => line.Split(' '))
                .Where(static words => words[1] != "A")
                .Select(static words => words[0].Split('@')[0])
                .Order(StringComparer.Ordinal),
        ];
    }

    // The lines that the preprocessor took from our headers.
    private static IEnumerable<string> OwnLines(IEnumerable<string> lines)
    {
        bool isOwn = false;
        foreach (string line in lines)
        {
            if (Marker().Match(line) is { Success: true } marker)
                isOwn = Path.GetFileName(marker.Groups["file"].Value) is "NeuronDataReader.h" or "DataType.h";
            else if (isOwn)
                yield return line.Trim();
        }
    }

    // One line for each declaration, definition or directive.
    private static IEnumerable<string> Statements(IEnumerable<string> lines)
    {
        var statement = new StringBuilder();
        int depth = 0;
        foreach (string line in lines.Where(static line => line.Length > 0))
        {
            if (line[0] == '#')
            {
                yield return line;
                continue;
            }

            statement.Append(statement.Length > 0 ? " " : "").Append(line);
            depth += line.Count(static sign => sign == '{') - line.Count(static sign => sign == '}');
            if (depth == 0 && (line[^1] == ';' || line == "}"))
            {
                yield return statement.ToString();
                statement.Clear();
            }
        }

        Assert.Equal("", statement.ToString());
    }

    [GeneratedRegex("^# [0-9]+ \"(?<file>.*)\"", RegexOptions.ExplicitCapture | RegexOptions.NonBacktracking)]
    private static partial Regex Marker();

    [GeneratedRegex(@"^[\w *]*?\b(?<name>\w+)\(", RegexOptions.ExplicitCapture | RegexOptions.NonBacktracking)]
    private static partial Regex Function();
}
