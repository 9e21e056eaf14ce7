using System.Text.Json;
using System.Xml.Linq;

namespace NeuronMocap.Unity.Tests.Package;

/// <summary>
/// The projects compile what Unity compiles: each project stands for one assembly definition, with its folder, name, references and libraries.
/// </summary>
public sealed class AssemblyDefinitionTests
{
    private static readonly string Package = Path.Combine(Repository.Root, "unity-package");
    private static readonly string Projects = Path.Combine(Repository.Root, "tests", "Unity", "Package");

    public static TheoryData<string> ProjectNames => [.. Directory.GetFiles(Projects, "*.csproj", SearchOption.AllDirectories).Select(path => Path.GetFileNameWithoutExtension(path))];

    [Theory]
    [MemberData(nameof(ProjectNames))]
    public void A_project_agrees_with_its_definition(string project)
    {
        XElement xml = XElement.Load(Path.Combine(Projects, project, $"{project}.csproj"));
        string folder = xml.Descendants("AssemblyFolder").Single().Value;
        bool isPlayer = project.EndsWith(".Player", StringComparison.Ordinal);
        foreach (Definition definition in GetDefinitions(folder))
        {
            // Samples are copied one by one. Here they are compiled together.
            string name = folder == "Samples~" ? definition.Name[..definition.Name.LastIndexOf('.')] : definition.Name;
            Assert.Equal(name, xml.Descendants("AssemblyName").Single().Value);
            Assert.Equal(definition.References.Order(), GetReferences(xml).Order());
            Assert.Equal(definition.Libraries.Order(), GetLibraries(xml).Order());
            Assert.True(definition.OverridesReferences && !definition.AllowsUnsafe && !definition.IsWithoutEngine);
            Assert.Equal(definition.IsForEditor, definition.Name.EndsWith("Editor", StringComparison.Ordinal) || definition.Name.EndsWith("EditMode", StringComparison.Ordinal));
            Assert.False(definition.IsForEditor && isPlayer);
        }
    }

    [Fact]
    public void Every_definition_and_every_script_is_compiled()
    {
        string[] folders = [.. Directory.GetFiles(Projects, "*.csproj", SearchOption.AllDirectories).Select(static path => XElement.Load(path).Descendants("AssemblyFolder").Single().Value).Distinct()];
        foreach (string path in Directory.GetFiles(Package, "*", SearchOption.AllDirectories).Where(static path => path.EndsWith(".cs", StringComparison.Ordinal) || path.EndsWith(".asmdef", StringComparison.Ordinal)))
        {
            string relative = Path.GetRelativePath(Package, path).Replace('\\', '/');
            Assert.Contains(folders, folder => relative.StartsWith(folder + "/", StringComparison.Ordinal));
        }

        // Unity assigns a script to the closest definition above it, so no definition may be inside another one's folder.
        foreach (string folder in folders.Where(static folder => folder != "Samples~"))
            Assert.Single(GetDefinitions(folder));
    }

    [Fact]
    public void Runtime_and_play_mode_are_compiled_for_players_as_well()
    {
        string[] players = [.. ProjectNames.Select(static row => row.Data).Where(static name => name.EndsWith(".Player", StringComparison.Ordinal)).Select(static name => name[..^".Player".Length])];

        Assert.Equal(["Compatibility", "InputSystem", "LiveCapture", "Runtime", "Samples", "Tests.PlayMode", "Timeline"], players.Order());
    }

    // Packages that a project may lack or remove.
    [Theory]
    [InlineData("com.unity.timeline", "Unity.Timeline", "NeuronMocap.Unity.Timeline", "NeuronMocap.Unity.Timeline.Editor")]
    [InlineData("com.unity.live-capture", "Unity.LiveCapture", "NeuronMocap.Unity.LiveCapture")]
    [InlineData("com.unity.inputsystem", "Unity.InputSystem", "NeuronMocap.Unity.InputSystem")]
    public void Only_the_assemblies_for_another_package_need_it(string package, string assembly, params string[] names)
    {
        string[] symbolsAndPackages = ["UNITY_INCLUDE_TESTS", "ENABLE_INPUT_SYSTEM", "com.unity.inputsystem", "com.unity.live-capture", "com.unity.timeline"];
        Definition[] all = [.. Directory.GetFiles(Package, "*.asmdef", SearchOption.AllDirectories).Select(static path => new Definition(JsonDocument.Parse(File.ReadAllText(path)).RootElement))];

        Assert.Equal(names, all.Where(definition => definition.References.Contains(assembly)).Select(static definition => definition.Name).Order());
        Assert.All(all, definition => Assert.Equal(!names.Contains(definition.Name), definition.IsCompiledWith([.. symbolsAndPackages.Except([package])])));
        Assert.All(all, definition => Assert.True(definition.IsCompiledWith(symbolsAndPackages)));
    }

    // Only Unity's own symbols may decide whether a script is compiled in one build and not in the other.
    [Fact]
    public void Scripts_use_only_defined_symbols()
    {
        string[] known = ["UNITY_EDITOR", "UNITY_2021_3_OR_NEWER", "UNITY_6000_1_OR_NEWER", "UNITY_IOS", "UNITY_ANDROID", "UNITY_WEBGL", "ENABLE_LEGACY_INPUT_MANAGER", "NEURONMOCAP_TIMELINE"];
        foreach (string path in Directory.GetFiles(Package, "*.cs", SearchOption.AllDirectories))
        {
            foreach (string line in File.ReadLines(path).Select(static line => line.Trim()).Where(static line => line.StartsWith("#if", StringComparison.Ordinal) || line.StartsWith("#elif", StringComparison.Ordinal)))
                Assert.All(line.Split(' ', '!', '(', ')', '&', '|').Where(static word => word.Length > 0 && word[0] != '#'), word => Assert.Contains(word, known));
        }
    }

    private static IEnumerable<Definition> GetDefinitions(string folder)
    {
        string[] paths = Directory.GetFiles(Path.Combine(Package, folder), "*.asmdef", SearchOption.AllDirectories);
        Assert.NotEmpty(paths);
        return paths.Select(static path => new Definition(JsonDocument.Parse(File.ReadAllText(path)).RootElement));
    }

    private static IEnumerable<string> GetReferences(XElement xml)
    {
        foreach (string path in xml.Descendants("ProjectReference").Select(static item => item.Attribute("Include")!.Value))
        {
            string name = Path.GetFileNameWithoutExtension(path);
            if (name == "UnityEngine.TestRunner")
            {
                // The editor part contains nothing that a test calls.
                yield return name;
                yield return "UnityEditor.TestRunner";
            }
            else if (name is "Unity.InputSystem" or "Unity.LiveCapture" or "Unity.Timeline")
            {
                yield return name;
            }
            else
            {
                yield return XElement.Load(Path.Combine(Projects, name, $"{name}.csproj")).Descendants("AssemblyName").Single().Value;
            }
        }
    }

    private static IEnumerable<string> GetLibraries(XElement xml) => xml.Descendants("Library")
        .SelectMany(static item => item.Attribute("Include")!.Value.Split(';'))
        .Select(static name => name + ".dll")
        .Concat(xml.Descendants("PackageReference").Select(static item => item.Attribute("Include")!.Value == "NUnit" ? "nunit.framework.dll" : "?"));

    private sealed class Definition(JsonElement json)
    {
        public string Name { get; } = json.GetProperty("name").GetString()!;

        public IEnumerable<string> References => GetStrings("references");

        public IEnumerable<string> Libraries => GetStrings("precompiledReferences");

        public bool IsForEditor => GetStrings("includePlatforms").SequenceEqual(["Editor"]);

        public bool OverridesReferences => json.GetProperty("overrideReferences").GetBoolean();

        public bool AllowsUnsafe => json.GetProperty("allowUnsafeCode").GetBoolean();

        public bool IsWithoutEngine => json.GetProperty("noEngineReferences").GetBoolean();

        // Whether all constraints are symbols that exist, or that an installed package defines.
        public bool IsCompiledWith(params string[] symbolsAndPackages)
        {
            IEnumerable<string> defined = json.GetProperty("versionDefines").EnumerateArray()
                .Where(item => symbolsAndPackages.Contains(item.GetProperty("name").GetString()))
                .Select(static item => item.GetProperty("define").GetString()!);
            return !GetStrings("defineConstraints").Except(symbolsAndPackages.Concat(defined)).Any();
        }

        private IEnumerable<string> GetStrings(string property) => json.GetProperty(property).EnumerateArray().Select(static item => item.GetString()!);
    }
}
