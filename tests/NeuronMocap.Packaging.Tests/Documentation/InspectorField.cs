using System.Globalization;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace NeuronMocap.Packaging.Tests.Documentation;

/// <summary>A field as the inspector shows it, from its attributes and its initial value.</summary>
internal sealed record InspectorField(string Name, string Type, string? Tooltip, string? Range, string? Initial, string? Header)
{
    public static IEnumerable<InspectorField> Of(TypeDeclarationSyntax type) => type.Members
        .OfType<FieldDeclarationSyntax>()
        .Where(IsShown)
        .SelectMany(static field => field.Declaration.Variables.Select(variable => Create(field, variable)));

    /// <summary>Converts a name as the inspector does: _bvhAsset becomes Bvh Asset.</summary>
    public static string Nicify(string name)
    {
        string words = string.Concat(name.TrimStart('_').Select(static (letter, i) => i > 0 && char.IsUpper(letter) ? $" {letter}" : letter.ToString()));
        return char.ToUpper(words[0], CultureInfo.InvariantCulture) + words[1..];
    }

    private static bool IsShown(FieldDeclarationSyntax field) =>
        Find(field, "HideInInspector") is null
        && Find(field, "NonSerialized") is null
        && (Find(field, "SerializeField") is not null || (field.Modifiers.Any(static word => word.Text == "public") && IsInstance(field) && IsSerializable(field.Parent)));

    private static bool IsInstance(FieldDeclarationSyntax field) => !field.Modifiers.Any(static word => word.Text is "static" or "const" or "readonly");

    private static bool IsSerializable(Microsoft.CodeAnalysis.SyntaxNode? type) =>
        type is TypeDeclarationSyntax declaration && declaration.AttributeLists.SelectMany(static list => list.Attributes).Any(static attribute => attribute.Name.ToString() == "Serializable");

    private static InspectorField Create(FieldDeclarationSyntax field, VariableDeclaratorSyntax variable) => new(
        Nicify(variable.Identifier.Text),
        field.Declaration.Type.ToString().TrimEnd('?'),
        Find(field, "Tooltip") is { } tooltip ? TextOf(ArgumentOf(tooltip, 0)) : null,
        RangeOf(field),
        variable.Initializer?.Value.ToString(),
        Find(field, "Header") is { } header ? TextOf(ArgumentOf(header, 0)) : null);

    private static string? RangeOf(FieldDeclarationSyntax field)
    {
        if (Find(field, "Range") is { } range)
            return $"{NumberOf(ArgumentOf(range, 0))} to {NumberOf(ArgumentOf(range, 1))}";

        return Find(field, "Min") is { } min ? $"{NumberOf(ArgumentOf(min, 0))} or more" : null;
    }

    private static AttributeSyntax? Find(FieldDeclarationSyntax field, string name) =>
        field.AttributeLists.SelectMany(static list => list.Attributes).FirstOrDefault(attribute => attribute.Name.ToString().Split('.')[^1] == name);

    private static ExpressionSyntax ArgumentOf(AttributeSyntax attribute, int index) => attribute.ArgumentList!.Arguments[index].Expression;

    private static string NumberOf(ExpressionSyntax number) => (ConstantOf(number) ?? number).ToString().TrimEnd('f');

    // The value of a constant of the same type.
    private static ExpressionSyntax? ConstantOf(ExpressionSyntax value) => value is not IdentifierNameSyntax name
        ? null
        : value.FirstAncestorOrSelf<TypeDeclarationSyntax>()!.Members
            .OfType<FieldDeclarationSyntax>()
            .SelectMany(static field => field.Declaration.Variables)
            .FirstOrDefault(variable => variable.Identifier.Text == name.Identifier.Text)?.Initializer?.Value;

    private static string TextOf(ExpressionSyntax text) => text switch
    {
        LiteralExpressionSyntax literal => literal.Token.ValueText,
        BinaryExpressionSyntax sum => TextOf(sum.Left) + TextOf(sum.Right),
        _ => throw new NotSupportedException($"A tooltip that is more than literals: {text}"),
    };
}
