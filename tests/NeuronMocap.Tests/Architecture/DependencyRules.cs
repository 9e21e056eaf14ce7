using System.Reflection;
using Mono.Cecil;
using Mono.Cecil.Cil;

namespace NeuronMocap.Tests.Architecture;

/// <summary>
/// Defines which folders below <paramref name="root"/> may use which others. Every type mentioned in a type's signatures and method bodies must
/// belong to the same folder or to an allowed one.
/// </summary>
/// <remarks>
/// Folders are those of the source files named in the assembly's symbols. Exceptions of the root folder may be thrown everywhere. Compiler-generated
/// code counts as its declaring type. Constants leave no trace in a compiled assembly, so their use is not detected.
/// </remarks>
internal sealed class DependencyRules(string root, IReadOnlyDictionary<string, string[]> allowed)
{
    // Replacements for types of the framework may be used everywhere, like the framework itself.
    private const string Polyfills = "Polyfills";

    /// <summary>Returns one line for each forbidden use, with the offending member first.</summary>
    public List<string> Violations(Assembly assembly)
    {
        using var module = ModuleDefinition.ReadModule(assembly.Location);
        var folders = SourceFolders.Read(assembly.Location, root);
        IEnumerable<string> missing = allowed.Keys.Except(folders.Values).Where(folder => !IsForOtherBuilds(folder));
        SortedSet<string> violations = new(missing.Select(static folder => $"{folder}: there is no such folder."), StringComparer.Ordinal);
        foreach (TypeDefinition type in module.GetTypes())
        {
            if (FolderOf(type, folders) is not { Length: > 0 } folder)
                continue;

            if (!allowed.TryGetValue(folder, out string[]? uses))
            {
                violations.Add($"{type.FullName}: the folder {folder} has no rule yet.");
                continue;
            }

            foreach ((string member, TypeReference used) in Uses(type))
            {
                foreach (TypeDefinition part in Parts(used).OfType<TypeDefinition>())
                {
                    if (FolderOf(part, folders) is { } target && !MayUse(folder, uses, target) && !IsRootException(assembly, target, part))
                        violations.Add($"{member} uses {part.FullName}: {folder} must not depend on {(target.Length == 0 ? "the root folder" : target)}.");
                }
            }
        }

        return [.. violations];
    }

    /// <summary>Folders that depend on themselves by the rules. Protocol and its text count as one.</summary>
    public IEnumerable<string> Circles() => allowed.Keys.Select(Family).Distinct(StringComparer.Ordinal).Where(family => Reaches(family, family, []));

    // The .NET Standard builds leave out files of .NET, and so whole folders of them.
    private bool IsForOtherBuilds(string folder)
    {
        string path = Infrastructure.Repository.PathOf(root.Trim('/'), folder);
        string[] files = Directory.Exists(path) ? Directory.GetFiles(path, "*.cs") : [];
        return files.Length > 0 && Array.TrueForAll(files, static file => file.EndsWith(".net.cs", StringComparison.Ordinal));
    }

    private bool Reaches(string from, string to, HashSet<string> seen) =>
        allowed.Where(rule => string.Equals(Family(rule.Key), from, StringComparison.Ordinal))
            .SelectMany(rule => rule.Value)
            .Select(Family)
            .Where(next => next.Length > 0 && !string.Equals(next, from, StringComparison.Ordinal))
            .Any(next => string.Equals(next, to, StringComparison.Ordinal) || (seen.Add(next) && Reaches(next, to, seen)));

    private static string Family(string folder) => folder is "Protocol/Text" ? "Protocol" : folder;

    private static bool MayUse(string folder, string[] uses, string target) =>
        string.Equals(folder, target, StringComparison.Ordinal) || target is Polyfills || uses.Contains(target, StringComparer.Ordinal);

    // Empty for the root itself, null for types without a source file below it.
    private static string? FolderOf(TypeDefinition type, IReadOnlyDictionary<uint, string> folders)
    {
        while (type.DeclaringType is not null)
            type = type.DeclaringType;

        return folders.GetValueOrDefault(type.MetadataToken.RID);
    }

    private static bool IsRootException(Assembly assembly, string folder, TypeDefinition type) =>
        folder.Length == 0 && typeof(Exception).IsAssignableFrom(assembly.GetType(type.FullName.Replace('/', '+')));

    private static IEnumerable<(string Member, TypeReference Type)> Uses(TypeDefinition type) =>
    [
        .. Named(type.FullName, OfType(type)),
        .. type.Fields.SelectMany(field => Named(field.FullName, [field.FieldType, .. Attributes(field)])),
        .. type.Properties.SelectMany(property => Named(property.FullName, [property.PropertyType, .. Attributes(property)])),
        .. type.Events.SelectMany(evt => Named(evt.FullName, [evt.EventType, .. Attributes(evt)])),
        .. type.Methods.SelectMany(method => Named(method.FullName, [.. OfSignature(method), .. OfBody(method)])),
    ];

    private static IEnumerable<(string Member, TypeReference Type)> Named(string member, IEnumerable<TypeReference?> types)
    {
        foreach (TypeReference? type in types)
        {
            if (type is not null)
                yield return (member, type);
        }
    }

    private static IEnumerable<TypeReference?> OfType(TypeDefinition type) =>
    [
        type.BaseType,
        .. type.Interfaces.Select(implementation => implementation.InterfaceType),
        .. Constraints(type),
        .. Attributes(type),
    ];

    private static IEnumerable<TypeReference> OfSignature(MethodDefinition method) =>
    [
        method.ReturnType,
        .. method.Parameters.Select(parameter => parameter.ParameterType),
        .. method.Parameters.SelectMany(Attributes),
        .. Attributes(method.MethodReturnType),
        .. Constraints(method),
        .. Attributes(method),
    ];

    private static IEnumerable<TypeReference?> OfBody(MethodDefinition method)
    {
        if (!method.HasBody)
            return [];

        return
        [
            .. method.Body.Variables.Select(variable => variable.VariableType),
            .. method.Body.ExceptionHandlers.Select(handler => handler.CatchType),
            .. method.Body.Instructions.SelectMany(OfInstruction),
        ];
    }

    private static IEnumerable<TypeReference> OfInstruction(Instruction instruction) => instruction.Operand switch
    {
        TypeReference type => [type],
        FieldReference field => [field.DeclaringType, field.FieldType],
        GenericInstanceMethod method => [.. OfCall(method), .. method.GenericArguments],
        MethodReference method => OfCall(method),
        CallSite site => [site.ReturnType, .. site.Parameters.Select(parameter => parameter.ParameterType)],
        _ => [],
    };

    private static IEnumerable<TypeReference> OfCall(MethodReference method) =>
        [method.DeclaringType, method.ReturnType, .. method.Parameters.Select(parameter => parameter.ParameterType)];

    private static IEnumerable<TypeReference> Constraints(IGenericParameterProvider generic) =>
        generic.GenericParameters.SelectMany(parameter => parameter.Constraints.Select(constraint => constraint.ConstraintType));

    private static IEnumerable<TypeReference> Attributes(global::Mono.Cecil.ICustomAttributeProvider provider)
    {
        foreach (CustomAttribute attribute in provider.CustomAttributes)
        {
            yield return attribute.AttributeType;
            foreach (CustomAttributeArgument argument in attribute.ConstructorArguments)
            {
                if (argument.Value is TypeReference type)
                    yield return type;
            }
        }
    }

    // The component types of a composed type: elements of arrays and references, arguments of generics.
    private static IEnumerable<TypeReference> Parts(TypeReference type) => type switch
    {
        GenericInstanceType generic => [generic.ElementType, .. generic.GenericArguments.SelectMany(Parts)],
        FunctionPointerType pointer => [.. Parts(pointer.ReturnType), .. pointer.Parameters.SelectMany(parameter => Parts(parameter.ParameterType))],
        IModifierType modifier => [.. Parts(modifier.ElementType), .. Parts(modifier.ModifierType)],
        TypeSpecification specification => Parts(specification.ElementType),
        GenericParameter => [],
        _ => [type],
    };
}
