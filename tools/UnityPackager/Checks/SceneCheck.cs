using System.Text.RegularExpressions;

namespace NeuronMocap.UnityPackager.Checks;

/// <summary>
/// Checks that scenes, prefabs and other text assets refer only to the package or to Unity itself. The sample of the conversion also has the
/// vendor's missing scripts.
/// </summary>
internal static partial class SceneCheck
{
    private static readonly string[] Extensions = [".unity", ".prefab", ".asset", ".mat", ".controller", ".anim", ".playable"];

    // Unity's default and extra resources.
    private static readonly string[] BuiltIn = ["0000000000000000e000000000000000", "0000000000000000f000000000000000"];

    // TimelineAsset of the package com.unity.timeline.
    private const string Timeline = "bfda56da833e2384a9677cd3c976a436";

    private const string VendorSample = $"{AssetPath.Samples}/VendorComponents/";

    // NeuronAnimatorInstance and NeuronTransformsInstance.
    private static readonly string[] Vendor = ["41173daca41f9a64b8552925c6a3c363", "b9f969a3a049578478f71ba66294d9d5"];

    public static IEnumerable<string> Check(StagedPackage package)
    {
        HashSet<string> known = [.. BuiltIn, Timeline, .. package.Files.Keys.Where(AssetPath.IsMeta).Select(path => MetaFile.FindGuid(package.ReadText(path))).OfType<string>()];
        foreach (string path in package.AssetFiles.Where(static path => Extensions.Contains(Path.GetExtension(path))))
        {
            foreach (string guid in Reference().Matches(package.ReadText(path)).Select(static match => match.Groups["guid"].Value).Distinct(StringComparer.Ordinal))
            {
                if (!known.Contains(guid) && !(path.StartsWith(VendorSample, StringComparison.Ordinal) && Vendor.Contains(guid)))
                    yield return $"{path}: refers to {guid}, which is not in the package";
            }
        }
    }

    [GeneratedRegex("guid: (?<guid>[0-9a-f]{32})", RegexOptions.None, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Reference();
}
