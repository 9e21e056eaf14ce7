using System.Text.RegularExpressions;

namespace NeuronMocap.Data.Tests.Vendor;

/// <summary>The tables of the vendor's C# types and methods, read from shared/unity.md section 1.1 if that file is beside the repository.</summary>
internal sealed partial class VendorTables
{
    private VendorTables(IReadOnlyList<string[]> types, IReadOnlyList<string[]> methods)
    {
        Types = types;
        Methods = methods;
    }

    /// <summary>Rows of the table of types: the item, then a cell for each of W1, W2 and managed.</summary>
    public IReadOnlyList<string[]> Types { get; }

    /// <summary>Rows of the table of methods, with the same columns.</summary>
    public IReadOnlyList<string[]> Methods { get; }

    public static VendorTables Require()
    {
        string path = Path.GetFullPath(Path.Combine(Repository.Root, "..", "shared", "unity.md"));
        Assert.SkipUnless(File.Exists(path), "shared/unity.md is not beside the repository.");
        string[] section =
        [
            .. File.ReadAllLines(path)
                .SkipWhile(static line => !line.StartsWith("### 1.1", StringComparison.Ordinal))
                .TakeWhile(static line => !line.StartsWith("### 1.2", StringComparison.Ordinal)),
        ];
        return new VendorTables(TableUnder(section, "| type |"), TableUnder(section, "| method |"));
    }

    public IEnumerable<string[]> TypesOf(string kind) => Types.Where(row => row[0].StartsWith(kind + " `", StringComparison.Ordinal));

    /// <summary>The texts in backticks, in order.</summary>
    public static IReadOnlyList<string> Code(string cell) => [.. CodeSpan().Matches(cell).Select(static match => match.Groups["code"].Value)];

    private static List<string[]> TableUnder(string[] section, string head)
    {
        IEnumerable<string> lines = section
            .SkipWhile(line => !line.StartsWith(head, StringComparison.Ordinal))
            .Skip(2)
            .TakeWhile(static line => line.StartsWith('|'));
        return [.. lines.Select(static line => line.Trim('|').Split('|').Select(static cell => cell.Trim()).ToArray())];
    }

    [GeneratedRegex("`(?<code>[^`]+)`", RegexOptions.None, matchTimeoutMilliseconds: 1000)]
    private static partial Regex CodeSpan();
}
