using System.Text.Json;

namespace NeuronMocap.UnityPackager.Checks;

/// <summary>
/// Checks that every source belongs to an assembly, and that references exist. An application must not get assemblies of the editor or tests.
/// </summary>
internal static class AssemblyDefinitionCheck
{
    private static readonly string[] TestAssemblies = ["UnityEngine.TestRunner", "UnityEditor.TestRunner"];
    private const string TestLibrary = "nunit.framework.dll";

    public static IEnumerable<string> Check(StagedPackage package)
    {
        IReadOnlyList<AssemblyDefinition> definitions;
        try
        {
            definitions = AssemblyDefinition.FindAll(package);
        }
        catch (Exception exception) when (exception is JsonException or KeyNotFoundException or InvalidOperationException)
        {
            return [$"an .asmdef cannot be read: {exception.Message}"];
        }

        return [.. definitions.SelectMany(definition => CheckOne(definition, definitions, package)), .. CheckSources(definitions, package)];
    }

    private static IEnumerable<string> CheckOne(AssemblyDefinition definition, IReadOnlyList<AssemblyDefinition> all, StagedPackage package)
    {
        string path = definition.Path;
        if (AssetPath.NameOf(path) != $"{definition.Name}.asmdef")
            yield return $"{path}: has the name {definition.Name}";
        if (all.Count(other => other.Name == definition.Name) > 1)
            yield return $"{path}: another assembly has this name, too";
        if (!definition.OverrideReferences)
            yield return $"{path}: would reference every library of a project (overrideReferences)";

        foreach (string reference in definition.References)
        {
            AssemblyDefinition? target = all.FirstOrDefault(other => other.Name == reference);
            if (target is null && !definition.MayReferenceOfOtherPackage(reference) && !(definition.IsTest && TestAssemblies.Contains(reference)))
                yield return $"{path}: the assembly {reference} does not exist";
            if (target is { IsEditorOnly: true } && !definition.IsEditorOnly)
                yield return $"{path}: {reference} exists only in the editor";
            if (target is { IsTest: true })
                yield return $"{path}: {reference} is a test";
        }

        foreach (string library in definition.PrecompiledReferences)
        {
            if (!package.Files.ContainsKey($"{MirroredFile.Libraries}/{library}") && !(definition.IsTest && library == TestLibrary))
                yield return $"{path}: the library {library} does not exist";
        }

        if (definition.IsTest && (definition.AutoReferenced || !definition.PrecompiledReferences.Contains(TestLibrary)))
            yield return $"{path}: a test names {TestLibrary} and is not referenced automatically";
        if (path.StartsWith("Tests/", StringComparison.Ordinal) != definition.IsTest)
            yield return $"{path}: tests are under Tests, and only there";
        if (path.StartsWith("Editor/", StringComparison.Ordinal) && !definition.IsEditorOnly)
            yield return $"{path}: would be part of applications";
    }

    private static IEnumerable<string> CheckSources(IReadOnlyList<AssemblyDefinition> definitions, StagedPackage package) => package.AssetFiles
        .Where(static path => path.EndsWith(".cs", StringComparison.Ordinal))
        .Where(path => AssemblyDefinition.Owning(path, definitions) is null)
        .Select(static path => $"{path} does not belong to an assembly");
}
