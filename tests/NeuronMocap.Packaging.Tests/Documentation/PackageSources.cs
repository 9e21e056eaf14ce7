using System.Text.RegularExpressions;
using System.Xml.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Packaging.Tests.Documentation;

/// <summary>The types of the package's runtime sources, and the enumerations of the library that its fields use.</summary>
internal sealed partial class PackageSources
{
    private static readonly Lazy<PackageSources> Loaded = new(Load);
    private readonly ILookup<string, TypeDeclarationSyntax> _types;
    private readonly Dictionary<string, EnumDeclarationSyntax> _enums;

    private PackageSources(IEnumerable<SyntaxNode> files, IEnumerable<SyntaxNode> library)
    {
        SyntaxNode[] own = [.. files];
        _types = own.SelectMany(static file => file.DescendantNodes()).OfType<TypeDeclarationSyntax>().ToLookup(static type => type.Identifier.Text, StringComparer.Ordinal);
        _enums = own.Concat(library)
            .SelectMany(static file => file.DescendantNodes())
            .OfType<EnumDeclarationSyntax>()
            .DistinctBy(static declaration => declaration.Identifier.Text, StringComparer.Ordinal)
            .ToDictionary(static declaration => declaration.Identifier.Text, StringComparer.Ordinal);
    }

    public static PackageSources All => Loaded.Value;

    /// <summary>The components of the menu, by their menu names.</summary>
    public IEnumerable<(string Menu, TypeDeclarationSyntax Type)> Components => _types
        .SelectMany(static types => types)
        .Select(static type => (Menu: MenuOf(type), type))
        .Where(static component => component.Menu is not null)
        .Select(static component => (component.Menu!, component.type))
        .OrderBy(static component => component.Item1, StringComparer.Ordinal);

    /// <summary>Inherited fields come first, as in the inspector.</summary>
    public IEnumerable<InspectorField> FieldsOf(string type) => _types[type].FirstOrDefault() is null
        ? []
        : BasesOf(type).SelectMany(FieldsOf).Concat(_types[type].SelectMany(InspectorField.Of));

    public EnumDeclarationSyntax? FindEnum(string type) => _enums.GetValueOrDefault(type.Split('.')[^1]);

    public bool IsStruct(string type) => _types[type].Any(static declaration => declaration is StructDeclarationSyntax);

    public bool HasFields(string type) => FieldsOf(type).Any();

    public string SummaryOf(string type) => _types[type].Select(SummaryOf).First(static summary => summary.Length > 0);

    /// <summary>The first paragraph of a summary, as plain text.</summary>
    public static string SummaryOf(SyntaxNode node)
    {
        string documentation = string.Concat(node.GetLeadingTrivia()
            .Where(static trivia => trivia.IsKind(SyntaxKind.SingleLineDocumentationCommentTrivia))
            .Select(static trivia => trivia.ToFullString()));
        if (documentation.Length == 0)
            return string.Empty;

        var parsed = XElement.Parse($"<doc>{CommentMark().Replace(documentation, " ")}</doc>");
        IEnumerable<XNode> summary = parsed.Element("summary")?.Nodes() ?? [];
        return WhiteSpace().Replace(string.Concat(summary.TakeWhile(static part => part is not XElement { Name.LocalName: "para" }).Select(TextOf)), " ").Trim();
    }

    private static string TextOf(XNode node) => node switch
    {
        XText text => text.Value,
        XElement { Name.LocalName: "see" or "paramref" } reference => $"`{(reference.Attribute("cref") ?? reference.Attribute("langword") ?? reference.Attribute("name"))!.Value.Split('.')[^1]}`",
        XElement element => element.Value,
        _ => string.Empty,
    };

    private IEnumerable<string> BasesOf(string type) => _types[type]
        .Where(static part => part.BaseList is not null)
        .SelectMany(static part => part.BaseList!.Types)
        .Select(static parent => parent.Type.ToString());

    private static string? MenuOf(TypeDeclarationSyntax type) => type.AttributeLists
        .SelectMany(static list => list.Attributes)
        .Where(static attribute => attribute.Name.ToString() == "AddComponentMenu")
        .Select(static attribute => ((LiteralExpressionSyntax)attribute.ArgumentList!.Arguments[0].Expression).Token.ValueText)
        .FirstOrDefault(static menu => menu.StartsWith("NeuronMocap/", StringComparison.Ordinal))?["NeuronMocap/".Length..];

    private static PackageSources Load() => new(
        Parse(Path.Combine(ThePackage.Folder, "Runtime")).Concat(Parse(Path.Combine(ThePackage.Folder, "LiveCapture"))),
        Parse(Repository.PathOf("src", "NeuronMocap"), "enum "));

    // Compiles like Unity's editor the files that contain a text.
    private static IEnumerable<SyntaxNode> Parse(string folder, string text = "") => Directory.EnumerateFiles(folder, "*.cs", SearchOption.AllDirectories)
        .Where(static file => !file.Contains($"{Path.DirectorySeparatorChar}obj{Path.DirectorySeparatorChar}", StringComparison.Ordinal))
        .Order(StringComparer.Ordinal)
        .Select(File.ReadAllText)
        .Where(source => source.Contains(text, StringComparison.Ordinal))
        .Select(static source => CSharpSyntaxTree.ParseText(source, new CSharpParseOptions(LanguageVersion.Latest, preprocessorSymbols: ["UNITY_EDITOR", "UNITY_2021_3_OR_NEWER"])).GetRoot());

    [GeneratedRegex("^\\s*///", RegexOptions.Multiline, matchTimeoutMilliseconds: 1000)]
    private static partial Regex CommentMark();

    [GeneratedRegex("\\s+", RegexOptions.None, matchTimeoutMilliseconds: 1000)]
    private static partial Regex WhiteSpace();
}
