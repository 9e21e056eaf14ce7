using System.Text;
using NeuronMocap.Packaging.Tests.Infrastructure;
using NeuronMocap.UnityPackager;
using NeuronMocap.UnityPackager.Checks;

namespace NeuronMocap.Packaging.Tests.Checks;

// Shows that every check can fail: each fault is put into the package and is the only finding.
public sealed class LintTests
{
    private const string Definition = "Runtime/NeuronMocap.Unity.asmdef";
    private const string Source = "Compatibility/ScriptSession.cs";
    private const string Library = "Runtime/Libraries/NeuronMocap.dll";

    public static TheoryData<string, string, string> Removals => new()
    {
        { $"{Definition}.meta", "Runtime/NeuronMocap.Unity.asmdef has no meta", "a file without a meta" },
        { "Runtime.meta", "Runtime has no meta", "a folder without a meta" },
        { "Samples~/QuickStart.meta", "Samples~/QuickStart has no meta", "a sample without a meta" },
        { "CHANGELOG.md", "CHANGELOG.md.meta: CHANGELOG.md does not exist", "a meta without its file" },
        { "LICENSE.md", "LICENSE.md is missing", "no licence" },
        { Library, "Runtime/Libraries/NeuronMocap.dll is missing", "no library" },
        { Library, "the library NeuronMocap.dll does not exist", "a reference to a library that is not there" },
        { "Runtime/Libraries/NeuronMocap.xml", "Runtime/Libraries/NeuronMocap.xml is missing", "no documentation" },
        { "Runtime/Libraries/NeuronMocap.pdb", "Runtime/Libraries/NeuronMocap.pdb is missing", "no symbols" },
        { "Compatibility/NeuronMocap.Unity.Compatibility.asmdef", "Compatibility/ScriptSession.cs does not belong to an assembly", "a source of no assembly" },
    };

    public static TheoryData<string, string, string, string> Edits => new()
    {
        { $"{Definition}.meta", "guid: ", "guid: g", "asmdef.meta: no GUID" },
        { $"{Definition}.meta", "AssemblyDefinitionImporter", "DefaultImporter", "asmdef.meta: DefaultImporter instead of AssemblyDefinitionImporter" },
        { "Runtime.meta", "folderAsset: yes\n", "", "Runtime.meta: describes a file as a folder" },
        { "Runtime.meta", "\n", "\r\n", "Runtime.meta: has Windows line ends" },
        { $"{Library}.meta", "enabled: 1", "enabled: 0", "NeuronMocap.dll.meta: other settings" },
        { $"{Library}.meta", "isExplicitlyReferenced: 0", "isExplicitlyReferenced: 1", "NeuronMocap.dll.meta: other settings" },
        { "Runtime/Sources/MocapSource.cs", "class MocapSource :", "class MotionSource :", "MocapSource.cs: Unity finds a component only in a file with its name" },
        { "package.json", "\"version\": \"", "\"version\": \"v", "version must look like 1.2.3" },
        { "package.json", "\"version\": \"", "\"version\": \"9", "package.json has 9" },
        { "package.json", "org.neuronmocap.unity", "NeuronMocap", "name must be lower-case letters" },
        { "package.json", "\"2021.3\"", "\"2021.3.1f1\"", "unity must look like 2021.3" },
        { "package.json", "\"displayName\": \"NeuronMocap\"", "\"displayName\": \"\"", "displayName is missing" },
        { "package.json", "\"author\"", "\"writer\"", "author lacks its url" },
        { "package.json", "\"repository\"", "\"home\"", "repository lacks its url" },
        { "package.json", "com.unity.modules.animation", "com.other.animation", "com.other.animation is not a module" },
        { "package.json", "Samples~/VrHead", "Samples~/VrHat", "the sample Samples~/VrHat does not exist" },
        { "package.json", "Samples~/VrHead", "Samples~/VrHat", "does not list the sample Samples~/VrHead" },
        { "package.json", "Samples~/VrHead", "Runtime", "the sample Runtime does not exist" },
        { "package.json", "{", "", "package.json: " },
        { Definition, "\"NeuronMocap.Unity\",", "\"Other\",", "has the name Other" },
        { Definition, "\"references\": []", "\"references\": [\"Missing\"]", "the assembly Missing does not exist" },
        { "Timeline/NeuronMocap.Unity.Timeline.asmdef", "\"Unity.Timeline\"", "\"Unity.Cinemachine\"", "the assembly Unity.Cinemachine does not exist" },
        { "Timeline/NeuronMocap.Unity.Timeline.asmdef", "\"define\": \"NEURONMOCAP_TIMELINE\"", "\"define\": \"OTHER\"", "the assembly Unity.Timeline does not exist" },
        { Definition, "\"references\": []", "\"references\": [\"NeuronMocap.Unity.Editor\"]", "NeuronMocap.Unity.Editor exists only in the editor" },
        { Definition, "\"references\": []", "\"references\": [\"NeuronMocap.Unity.Tests.PlayMode\"]", "is a test" },
        { Definition, "\"references\": []", "\"references\": [\"UnityEngine.TestRunner\"]", "the assembly UnityEngine.TestRunner does not exist" },
        { Definition, "\"NeuronMocap.dll\"", "\"Other.dll\"", "the library Other.dll does not exist" },
        { Definition, "\"overrideReferences\": true", "\"overrideReferences\": false", "would reference every library" },
        { "Editor/NeuronMocap.Unity.Editor.asmdef", "\"Editor\"\n", "", "would be part of applications" },
        { "Tests/PlayMode/NeuronMocap.Unity.Tests.PlayMode.asmdef", "UNITY_INCLUDE_TESTS", "OTHER", "tests are under Tests" },
        { "Tests/PlayMode/NeuronMocap.Unity.Tests.PlayMode.asmdef", "\"autoReferenced\": false", "\"autoReferenced\": true", "not referenced automatically" },
        { Source, "#nullable enable", "", "lacks #nullable enable" },
        { Source, "namespace NeuronMocap.Unity", "namespace Other", "does not use a namespace of the package" },
        { Source, "#if UNITY_EDITOR", "#if DEBUG", "uses the editor outside #if UNITY_EDITOR" },
        { Source, "#if UNITY_EDITOR", "#if UNITY_EDITOR || DEBUG", "uses the editor outside #if UNITY_EDITOR" },
        { Source, "#if UNITY_EDITOR", "#if UNITY_EDITOR\n#else", "uses the editor outside #if UNITY_EDITOR" },
    };

    [Theory]
    [MemberData(nameof(Removals))]
    public void Missing_files_are_found(string path, string finding, string what)
    {
        StagedPackage package = ThePackage.With(files => Assert.True(files.Remove(path), path));

        Assert.True(Finds(package, finding), what);
    }

    [Theory]
    [MemberData(nameof(Edits))]
    public void Invalid_files_are_found(string path, string before, string after, string finding)
    {
        StagedPackage package = ThePackage.With(files =>
        {
            string text = Encoding.UTF8.GetString(files[path]);
            Assert.Contains(before, text, StringComparison.Ordinal);
            files[path] = Encoding.UTF8.GetBytes(text.Replace(before, after, StringComparison.Ordinal));
        });

        Assert.True(Finds(package, finding), string.Join('\n', PackageLint.Check(package)));
    }

    [Fact]
    public void A_guid_used_twice_is_found()
    {
        StagedPackage package = ThePackage.With(static files => files["Editor.meta"] = files["Runtime.meta"]);
        Assert.Equal(["Runtime.meta: the GUID is that of Editor"], PackageLint.Check(package));
    }

    [Theory]
    [InlineData("Runtime/Libraries/System.Memory.dll")]
    [InlineData("Runtime/Libraries/NeuronMocap.so")]
    [InlineData("Editor/NeuronMocap.dll")]
    [InlineData("Runtime/Libraries/NeuronDataReader.DLL")]
    [InlineData("Runtime/Libraries/NeuronDataReader.aar")]
    [InlineData("Runtime/Native.mm")]
    public void A_foreign_library_is_found(string path)
    {
        StagedPackage package = ThePackage.With(files =>
        {
            files[path] = files[Library];
            files[$"{path}.meta"] = Encoding.UTF8.GetBytes(MetaFile.Create(path, isFolder: false, MetaFile.DeriveGuid(path)));
        });
        Assert.Equal([$"{path}: is not one of our libraries"], PackageLint.Check(package));
    }

    [Fact]
    public void Names_that_collide_on_Windows_are_found()
    {
        const string path = "Runtime/conversions.cs";
        StagedPackage package = ThePackage.With(static files =>
        {
            files[path] = files["Runtime/Conversions.cs"];
            files[$"{path}.meta"] = Encoding.UTF8.GetBytes(MetaFile.Create(path, isFolder: false, MetaFile.DeriveGuid(path)));
        });
        Assert.Equal(["Runtime/Conversions.cs and Runtime/conversions.cs: one file on Windows and macOS"], PackageLint.Check(package));
    }

    [Fact]
    public void A_missing_dependency_of_a_library_is_found()
    {
        StagedPackage package = ThePackage.With(static files => files[Library] = File.ReadAllBytes(typeof(LintTests).Assembly.Location));
        Assert.Contains(PackageLint.Check(package), static problem => problem.Contains("needs System.Runtime", StringComparison.Ordinal));
        Assert.Contains(PackageLint.Check(package), static problem => problem.Contains("needs xunit", StringComparison.Ordinal));
        Assert.Contains(PackageLint.Check(package), static problem => problem.Contains("Unity strips members that are only found by reflection", StringComparison.Ordinal));
    }

    [Fact]
    public void A_path_of_this_machine_in_symbols_is_found()
    {
        string symbols = Path.ChangeExtension(typeof(LintTests).Assembly.Location, ".pdb");
        StagedPackage package = ThePackage.With(files => files["Runtime/Libraries/NeuronMocap.pdb"] = File.ReadAllBytes(symbols));
        Assert.True(Finds(package, "a path of the computer that built it"));
    }

    [Fact]
    public void A_broken_scene_reference_is_found()
    {
        const string path = "Samples~/QuickStart/Test.unity";
        const string guid = "00112233445566778899aabbccddeeff";
        StagedPackage package = ThePackage.With(files =>
        {
            files[path] = Encoding.UTF8.GetBytes($"m_Script: {{fileID: 11500000, guid: {guid}, type: 3}}\nm_Mesh: {{fileID: 1, guid: 0000000000000000e000000000000000, type: 0}}\n");
            files[$"{path}.meta"] = Encoding.UTF8.GetBytes(MetaFile.Create(path, isFolder: false, MetaFile.DeriveGuid(path)));
        });
        Assert.Equal([$"{path}: refers to {guid}, which is not in the package"], PackageLint.Check(package));
    }

    [Fact]
    public void Only_the_sample_of_the_conversion_may_lack_the_vendors_scripts()
    {
        StagedPackage package = ThePackage.With(static files =>
            files["Samples~/QuickStart/QuickStart.unity"] = files["Samples~/VendorComponents/VendorComponents.unity"]);
        Assert.True(Finds(package, "QuickStart.unity: refers to 41173daca41f9a64b8552925c6a3c363"));
    }

    private static bool Finds(StagedPackage package, string finding) =>
        PackageLint.Check(package).Any(problem => problem.Contains(finding, StringComparison.Ordinal));
}
