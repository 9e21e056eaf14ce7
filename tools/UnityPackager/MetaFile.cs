using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;

namespace NeuronMocap.UnityPackager;

/// <summary>
/// The texts of Unity's .meta files. A meta holds the asset's GUID, with which scenes and prefabs refer to it, and its import settings.
/// </summary>
internal static partial class MetaFile
{
    private const string PackageName = "org.neuronmocap.unity";
    private const string Labels = "  userData: \n  assetBundleName: \n  assetBundleVariant: \n";

    /// <summary>
    /// Derives the GUID of an asset without a meta from its path, so that every build gives the same GUID. It stays when the asset moves.
    /// </summary>
    public static string DeriveGuid(string path)
    {
        byte[] hash = SHA256.HashData(Encoding.UTF8.GetBytes($"{PackageName}/{path}"));
        return Convert.ToHexStringLower(hash.AsSpan(0, 16));
    }

    /// <summary>Finds the GUID in the text of a meta, or null.</summary>
    public static string? FindGuid(string text) => GuidLine().Match(text) is { Success: true } match ? match.Groups["value"].Value : null;

    /// <summary>Finds the importer in the text of a meta, or null.</summary>
    public static string? FindImporter(string text) => ImporterLine().Match(text) is { Success: true } match ? match.Groups["value"].Value : null;

    /// <summary>Creates a meta as Unity 2021.3 writes it.</summary>
    public static string Create(string path, bool isFolder, string guid) =>
        $"fileFormatVersion: 2\nguid: {guid}\n{(isFolder ? Folder() : File(path))}{Labels}";

    private static string Folder() => $"folderAsset: yes\n{Importer("DefaultImporter")}";

    private static string File(string path) => path == "package.json" ? Importer("PackageManifestImporter") : Path.GetExtension(path) switch
    {
        ".cs" => Importer("MonoImporter", "  serializedVersion: 2\n  defaultReferences: []\n  executionOrder: 0\n  icon: {instanceID: 0}\n"),
        ".dll" => Importer("PluginImporter", Plugin),
        ".asmdef" => Importer("AssemblyDefinitionImporter"),
        ".md" or ".txt" or ".xml" or ".json" or ".bytes" => Importer("TextScriptImporter"),
        ".png" or ".jpg" => Importer("TextureImporter"),
        ".prefab" => Importer("PrefabImporter"),
        ".mat" => Importer("NativeFormatImporter", "  mainObjectFileID: 2100000\n"),
        ".asset" or ".playable" => Importer("NativeFormatImporter", "  mainObjectFileID: 11400000\n"),
        ".controller" => Importer("NativeFormatImporter", "  mainObjectFileID: 9100000\n"),
        ".anim" => Importer("NativeFormatImporter", "  mainObjectFileID: 7400000\n"),
        _ => Importer("DefaultImporter"),
    };

    private static string Importer(string name, string settings = "") => $"{name}:\n  externalObjects: {{}}\n{settings}";

    // For every platform and the editor. Other assemblies of the project may use the library without naming it. Unity checks that its references
    // exist.
    private const string Plugin = """
          serializedVersion: 2
          iconMap: {}
          executionOrder: {}
          defineConstraints: []
          isPreloaded: 0
          isOverridable: 0
          isExplicitlyReferenced: 0
          validateReferences: 1
          platformData:
          - first:
              Any: 
            second:
              enabled: 1
              settings: {}
          - first:
              Editor: Editor
            second:
              enabled: 0
              settings:
                DefaultValueInitialized: true
          - first:
              Windows Store Apps: WindowsStoreApps
            second:
              enabled: 0
              settings:
                CPU: AnyCPU

        """;

    [GeneratedRegex("^guid: (?<value>[0-9a-f]{32})$", RegexOptions.Multiline, matchTimeoutMilliseconds: 1000)]
    private static partial Regex GuidLine();

    [GeneratedRegex("^(?<value>[A-Za-z]+Importer):", RegexOptions.Multiline, matchTimeoutMilliseconds: 1000)]
    private static partial Regex ImporterLine();
}
