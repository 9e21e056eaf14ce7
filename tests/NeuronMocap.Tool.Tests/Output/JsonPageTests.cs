using System.Net;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using NeuronMocap.Diagnostics;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Commands;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Relay.Destinations;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Output;

/// <summary>Compares docs/reference/json.md with the lines that are written.</summary>
public sealed partial class JsonPageTests
{
    private static readonly string[] Page = File.ReadAllLines(Repository.PathOf("docs/reference/json.md"));

    private readonly JsonLines _lines = new();

    [Fact]
    public async Task The_page_lists_exactly_the_fields_of_every_line()
    {
        ToolResult diagnosis = await ToolRunner.RunAsync("diagnose", "demo", "--quiet", "--duration", "15");
        Dictionary<string, SortedSet<string>> written = [];
        foreach (string line in AllLines().Append(diagnosis.Output[^1]))
        {
            using var document = JsonDocument.Parse(line);
            string type = document.RootElement.GetProperty("type").GetString()!;
            if (!written.TryGetValue(type, out SortedSet<string>? fields))
                written[type] = fields = new SortedSet<string>(StringComparer.Ordinal);

            Collect(document.RootElement, string.Empty, fields);
        }

        // One line of every kind that the class can write, so that a new kind cannot be forgotten here.
        Assert.Superset(
            typeof(JsonLines).GetMethods(BindingFlags.Public | BindingFlags.Instance)
                .Where(static method => method.ReturnType == typeof(ReadOnlySpan<byte>))
                .Select(static method => char.ToLowerInvariant(method.Name[0]) + method.Name[1..])
                .ToHashSet(StringComparer.Ordinal),
            written.Keys.ToHashSet(StringComparer.Ordinal));
        Dictionary<string, SortedSet<string>> described = ReadPage();
        Assert.Equal(described.Keys.Order(StringComparer.Ordinal), written.Keys.Order(StringComparer.Ordinal));
        Assert.All(described, entry =>
        {
            string missing = string.Join(", ", written[entry.Key].Except(entry.Value, StringComparer.Ordinal));
            string stale = string.Join(", ", entry.Value.Except(written[entry.Key], StringComparer.Ordinal));
            Assert.True(missing.Length + stale.Length == 0, $"docs/reference/json.md, lines of type {entry.Key}: not described: {missing}; described, but not written: {stale}.");
        });
    }

    [Fact]
    public void Every_reason_has_its_own_documented_code()
    {
        ConnectionReason[] reasons = Enum.GetValues<ConnectionReason>();
        string[] codes = [.. reasons.Select(ReasonCode.Of)];

        Assert.Equal(reasons.Select(reason => Humps().Replace(reason.ToString(), "-$0").ToLowerInvariant()), codes);
        Assert.Equal(codes, Page.Select(line => Code().Match(line)).Where(static match => match.Success).Select(static match => match.Groups["code"].Value).Where(codes.Contains));
    }

    [Theory]
    [InlineData("watch")]
    [InlineData("relay", "demo", "tcp://127.0.0.1:0", "--duration", "1.5")]
    [InlineData("diagnose", "demo", "--duration", "15")]
    [InlineData("command", "demo")]
    [InlineData("command", "demo", "bones")]
    [InlineData("command", "demo", "zero-out")]
    public async Task Every_line_of_a_run_parses_and_has_a_documented_type(params string[] args)
    {
        ToolResult result = await ToolRunner.RunAsync([.. args, "--json", .. (string[])(args.Length == 1 ? ["--frames", "5"] : [])]);

        Assert.Equal(0, result.ExitCode);
        Dictionary<string, SortedSet<string>> described = ReadPage();
        Assert.NotEmpty(result.Output);
        Assert.All(result.Output, line =>
        {
            using var document = JsonDocument.Parse(line);
            var fields = new SortedSet<string>(StringComparer.Ordinal);
            Collect(document.RootElement, string.Empty, fields);
            Assert.Subset(described[document.RootElement.GetProperty("type").GetString()!], fields);
        });
    }

    [Fact]
    public void Every_unit_and_every_scheme_is_named()
    {
        string[] units = [.. typeof(Outlet).Assembly.GetTypes().Where(static type => type.IsSubclassOf(typeof(Outlet)) && !type.IsAbstract)
            .Select(static type => ((Outlet)RuntimeHelpers.GetUninitializedObject(type)).Unit)];
        Assert.Contains("poses", units);
        string unit = RowOf("opened", "unit");
        Assert.All(units, word => Assert.Contains($"`{word}`", unit, StringComparison.Ordinal));

        string source = RowOf("start", "source");
        Assert.All(Scheme().Matches(Source.Forms), match => Assert.Contains($"`{match.Value}", source, StringComparison.Ordinal));
        string destination = RowOf("opened", "destination");
        Assert.All(Scheme().Matches(Destination.Forms), match => Assert.Contains($"`{match.Value}", destination, StringComparison.Ordinal));
    }

    private static string RowOf(string type, string field) =>
        Page.SkipWhile(line => line != $"## {type}").First(line => line.StartsWith($"| `{field}` |", StringComparison.Ordinal));

    private static void Collect(JsonElement element, string path, SortedSet<string> fields)
    {
        if (element.ValueKind == JsonValueKind.Array)
        {
            foreach (JsonElement item in element.EnumerateArray().Where(static item => item.ValueKind == JsonValueKind.Object))
                Collect(item, $"{path}[]", fields);
        }

        foreach (JsonProperty property in element.ValueKind == JsonValueKind.Object ? [.. element.EnumerateObject()] : Array.Empty<JsonProperty>())
        {
            string name = path.Length == 0 ? property.Name : $"{path}.{property.Name}";
            fields.Add(name);
            Collect(property.Value, name, fields);
        }
    }

    private static Dictionary<string, SortedSet<string>> ReadPage()
    {
        Dictionary<string, SortedSet<string>> described = [];
        SortedSet<string>? fields = null;
        foreach (string line in Page)
        {
            if (line.StartsWith("## ", StringComparison.Ordinal))
                described[line[3..]] = fields = new SortedSet<string>(StringComparer.Ordinal);
            else if (line.StartsWith("Codes of", StringComparison.Ordinal))
                fields = null;
            else if (Code().Match(line) is { Success: true } match)
                fields?.Add(match.Groups["code"].Value);
        }

        return described;
    }

    private IEnumerable<string> AllLines()
    {
        var header = new MotionHeader { Version = DataVersion.Studio, AvatarName = new AvatarName("A"), Reserved1 = 0x0A0B0C, Reserved2 = 7 };
        var studio = new StudioCalculationHeader { AvatarName = new AvatarName("A") };
        yield return Text(_lines.Start("demo"));
        yield return Text(_lines.Skeleton(Poses.Upright()));
        yield return Text(_lines.Frame(Poses.Upright()));
        yield return Text(_lines.Frame(new MotionFrame(header, [1])));
        yield return Text(_lines.Calculation(new CalculationFrame(new CalculationHeader(), [1])));
        yield return Text(_lines.StudioCalculation(new StudioCalculationFrame(studio, new byte[StudioCalculationFrame.FullByteCount])));
        yield return Text(_lines.StudioCalculation(new StudioCalculationFrame(studio, new byte[8])));
        yield return Text(_lines.Status(new ConnectionStatus(ConnectionState.Waiting, ConnectionReason.Refused, "No.")
        {
            RetryIn = TimeSpan.FromSeconds(1),
            LocalEndPoint = new IPEndPoint(IPAddress.Loopback, 1),
            ReceiveBufferSize = 1,
        }));
        yield return Text(_lines.FileFailed(new FileFailure("export", "take.bvh", "the disk is full.", 7, 0)));
        yield return Text(_lines.FileFailed(new FileFailure("recording", "take.nmrec", "the disk is full.", 7, 0)));
        var flow = new FlowFigures("tcp://127.0.0.1:7001", "packets", "ok", 1, 2, 3);
        yield return Text(_lines.Opened(flow.Destination, flow.Unit));
        yield return Text(_lines.Received(default, 1));
        yield return Text(_lines.Flow(flow));
        yield return Text(_lines.Summary(default(ReaderStatistics)));
        yield return Text(_lines.Summary(default, [flow]));
        yield return Text(_lines.Step(new DiagnosisStep("port", StepOutcome.Ok, "open", TimeSpan.Zero)));
        var server = new ServerAddress("studio", 8013);
        yield return CommandJson.ZeroOut(server, 0);
        yield return CommandJson.Report(new CommandResults(server, 0) { Order = RotationOrder.YXZ, Sizes = default(BoneDimensions), Header = "HIERARCHY" });
    }

    private static string Text(ReadOnlySpan<byte> line) => Encoding.UTF8.GetString(line);

    [GeneratedRegex("^\\| `(?<code>[^`]+)` \\|", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Code();

    [GeneratedRegex("[a-z]+://", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Scheme();

    [GeneratedRegex("(?<!^)[A-Z]", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Humps();
}
