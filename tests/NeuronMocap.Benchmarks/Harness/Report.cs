using System.Globalization;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Runtime.Versioning;
using System.Text.Json;

namespace NeuronMocap.Benchmarks.Harness;

// What a command measured, and where.
internal sealed record Results(string Command, string Build, int Processors, string Processor, string System, string Runtime, IReadOnlyList<Row> Rows);

// Prints rows as a Markdown table as they arrive, and writes all of them as JSON at the end.
internal sealed class Report(string command, FileInfo? json)
{
    private static readonly JsonSerializerOptions Indented = new() { WriteIndented = true, PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    private readonly List<Row> _rows = [];

    // The build of the library that is measured: net8.0, netstandard2.1 or netstandard2.0.
    private static string Build => typeof(NeuronReader).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName switch
    {
        ".NETCoreApp,Version=v8.0" => "net8.0",
        ".NETStandard,Version=v2.1" => "netstandard2.1",
        ".NETStandard,Version=v2.0" => "netstandard2.0",
        var other => other,
    };

    public void Begin(string what)
    {
        Console.WriteLine();
        Console.WriteLine($"### {command}, {Build}");
        Console.WriteLine();
        Console.WriteLine(what);
        Console.WriteLine();
        Console.WriteLine("| case | way | figure | value | floor | ratio (lowest to highest) | aim | |");
        Console.WriteLine("|---|---|---|---:|---:|---:|---|---|");
    }

    public void Add(IEnumerable<Row> rows)
    {
        foreach (Row row in rows)
        {
            _rows.Add(row);
            if (row.IsFloor)
                continue;

            string ratio = row.Ratio is { } spread ? $"{Text(spread.Median)} ({Text(spread.Low)} to {Text(spread.High)})" : string.Empty;
            string met = row.IsMet switch { true => "met", false => "missed", null => string.Empty };
            string floor = row.Floor is { } value ? Text(value) : string.Empty;
            Console.WriteLine($"| {row.Case} | {row.Way} | {row.Figure} | {Text(row.Value)} | {floor} | {ratio} | {row.Aim} | {met} |");
        }
    }

    // Returns the exit code. A missed aim is a result, not a failure.
    public int End()
    {
        if (json is null)
            return 0;

        var results = new Results(
            command, Build, Environment.ProcessorCount, Processor(), RuntimeInformation.OSDescription, RuntimeInformation.FrameworkDescription, _rows);
        File.WriteAllText(json.FullName, JsonSerializer.Serialize(results, Indented));
        return 0;
    }

    public static Results Read(string path) => JsonSerializer.Deserialize<Results>(File.ReadAllText(path), Indented)!;

    public IReadOnlyList<Row> Rows => _rows;

    public static string Text(double value) => Math.Abs(value) switch
    {
        0 => "0",
        >= 1000 => value.ToString("#,##0", CultureInfo.InvariantCulture),
        >= 100 => value.ToString("0", CultureInfo.InvariantCulture),
        >= 10 => value.ToString("0.0", CultureInfo.InvariantCulture),
        >= 0.01 => value.ToString("0.00", CultureInfo.InvariantCulture),
        _ => value.ToString("0.######", CultureInfo.InvariantCulture),
    };

    private static string Processor()
    {
        const string CpuInfo = "/proc/cpuinfo";
        string? line = File.Exists(CpuInfo) ? File.ReadLines(CpuInfo).FirstOrDefault(static line => line.StartsWith("model name", StringComparison.Ordinal)) : null;
        return line?.Split(':')[1].Trim() ?? RuntimeInformation.ProcessArchitecture.ToString();
    }
}
