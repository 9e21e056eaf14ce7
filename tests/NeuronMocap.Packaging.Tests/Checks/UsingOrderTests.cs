using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Checks;

/// <summary>The order of usings, as <c>dotnet format style --diagnostics IMPORTS</c> wants it. Loading the solution for that takes a minute of two cores.</summary>
public partial class UsingOrderTests
{
    [Fact]
    public void Every_file_sorts_its_usings()
    {
        string[] files = [.. Directory.EnumerateFiles(Repository.Root, "*.cs", SearchOption.AllDirectories).Where(IsSource)];
        Assert.True(files.Length > 1000, $"{files.Length} files");
        Assert.All(files, static file => Assert.Null(FindFault(File.ReadAllText(file))));
    }

    [Theory]
    [InlineData(null, "using System;", "using System.IO;", "using NeuronMocap;", "using NeuronMocap.Skeleton;", "using static System.Math;", "using A = System.Int32;")]
    [InlineData("using Alpha;", "using Beta;", "using Alpha;")]
    [InlineData("using System.IO;", "using NeuronMocap;", "using System.IO;")]
    [InlineData("using NeuronMocap;", "using NeuronMocap.Skeleton;", "using NeuronMocap;")]
    [InlineData("using Beta;", "using static System.Math;", "using Beta;")]
    [InlineData("using static System.Math;", "using A = System.Int32;", "using static System.Math;")]
    public void A_wrong_place_is_found(string? fault, params string[] usings) => Assert.Equal(fault, FindFault(string.Join('\n', usings)));

    private static string? FindFault(string source)
    {
        SyntaxList<UsingDirectiveSyntax> usings = ((CompilationUnitSyntax)CSharpSyntaxTree.ParseText(HeadOf(source)).GetRoot()).Usings;
        for (int i = 1; i < usings.Count; i++)
        {
            // Lines of #if separate groups, each with an order of its own.
            if (!usings[i].GetLeadingTrivia().Any(static trivia => trivia.IsDirective) && Compare(usings[i - 1], usings[i]) > 0)
                return usings[i].ToString();
        }

        return null;
    }

    // The file to the end of its last line that can be a using. Parsing the code below takes most of the time.
    private static string HeadOf(string source) => UsingLine().Match(source) is { Success: true } last ? source[..(last.Index + last.Length)] : string.Empty;

    private static int Compare(UsingDirectiveSyntax one, UsingDirectiveSyntax other)
    {
        int kinds = KindOf(one).CompareTo(KindOf(other));
        return kinds != 0 ? kinds : string.Compare(KeyOf(one), KeyOf(other), StringComparison.OrdinalIgnoreCase);
    }

    // Namespaces of System, other namespaces, classes, aliases.
    private static int KindOf(UsingDirectiveSyntax directive)
    {
        if (directive.Alias is not null)
            return 3;
        if (directive.StaticKeyword.IsKind(SyntaxKind.StaticKeyword))
            return 2;

        return KeyOf(directive).Split('.')[0] == "System" ? 0 : 1;
    }

    private static string KeyOf(UsingDirectiveSyntax directive) => directive.Alias?.Name.ToString() ?? directive.Name!.ToString();

    private static bool IsSource(string file) =>
        !Path.GetRelativePath(Repository.Root, file).Split(Path.DirectorySeparatorChar).Any(static part => part is "bin" or "obj" or "artifacts" || part.StartsWith('.'));

    [GeneratedRegex(@"^\s*(global\s+)?using\s+(static\s+|unsafe\s+)*[\w.:]+(\s*=[^;]+)?;.*$", RegexOptions.Multiline | RegexOptions.RightToLeft | RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex UsingLine();
}
