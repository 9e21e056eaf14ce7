using System.Reflection;
using Mono.Cecil;
using Mono.Cecil.Cil;

namespace NeuronMocap.Tests.Architecture;

/// <summary>
/// Which folders of an assembly may use which: every type that a type of one folder mentions, in signatures and in method bodies, has to
/// belong to the same folder or to an allowed one. Exceptions of the root namespace may be thrown everywhere. What the compiler generates
/// counts as its declaring type; constants leave no trace in a compiled assembly and cannot be seen.
/// </summary>
internal sealed class DependencyRules(string root, IReadOnlyDictionary<string, string[]> allowed)
{
    /// <summary>One line for each forbidden use, the offending member first.</summary>
    public List<string> Violations(Assembly assembly)
    {
        using var module = ModuleDefinition.ReadModule(assembly.Location);
        SortedSet<string> violations = new(StringComparer.Ordinal);
        foreach (TypeDefinition type in module.GetTypes())
        {
            if (FolderOf(type) is not { } folder || folder.Length == 0)
                continue;

            if (!allowed.TryGetValue(folder, out string[]? uses))
            {
                violations.Add($"{type.FullName}: the folder {folder} has no rule yet.");
                continue;
            }

            foreach ((string member, TypeReference used) in Uses(type))
            {
                foreach (TypeReference part in Parts(used))
                {
                    if (FolderOf(part) is { } target && !MayUse(folder, uses, target) && !IsRootException(assembly, target, part))
                        violations.Add($"{member} uses {part.FullName}: {folder} must not depend on {Describe(target)}.");
                }
            }
        }

        return [.. violations];
    }

    private static bool MayUse(string folder, string[] uses, string target) =>
        string.Equals(folder, target, StringComparison.Ordinal) || uses.Contains(target, StringComparer.Ordinal);

    private string Describe(string folder) => folder.Length == 0 ? $"the root namespace {root}" : folder;

    // The first part of the namespace below the root, empty for the root itself, null for everybody else's types.
    private string? FolderOf(TypeReference type)
    {
        while (type.DeclaringType is not null)
            type = type.DeclaringType;

        if (string.Equals(type.Namespace, root, StringComparison.Ordinal))
            return "";

        return type.Namespace.StartsWith(root + ".", StringComparison.Ordinal) ? type.Namespace[(root.Length + 1)..].Split('.')[0] : null;
    }

    private static bool IsRootException(Assembly assembly, string folder, TypeReference type) =>
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

    private static IEnumerable<TypeReference> Attributes(Mono.Cecil.ICustomAttributeProvider provider)
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

    // The types that a composed one is made of: elements of arrays and references, arguments of generics.
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
