#nullable enable

using UnityEditor;

namespace NeuronMocap.Unity.EditorTools
{
    // The rules and messages of the checks, separate from the editor calls that apply them.
    internal static class BuildRules
    {
        public const string PlatformsPage = "the page 'Platforms' of the package's documentation (Documentation~/platforms.md)";

        public const string MissingTextAdvice =
            "NeuronMocap: the text for the device's question about the local network is empty. Without it, iOS 14, tvOS 14, visionOS 1 and newer answer "
            + "every connection in the local network with 'no route'. Write one in Edit, Project Settings, NeuronMocap.";

        public const string TextNotAddedAdvice =
            "NeuronMocap: the Info.plist has no " + InfoPlist.LocalNetworkKey + ", and adding one is off in Edit, Project Settings, NeuronMocap. "
            + "Without it, iOS 14, tvOS 14, visionOS 1 and newer answer every connection in the local network with 'no route'.";

        public const string PermissionAdvice =
            "NeuronMocap: this Android build may lack the network permission. Without it, no source receives anything. Set Internet "
            + "Access to Require in the Android player settings, or switch 'Require Internet Permission' on in Edit, Project Settings, NeuronMocap.";

        public const string PermissionSet =
            "NeuronMocap: Internet Access of the Android player settings is now Require, so that sources can receive. "
            + "You can switch this off in Edit, Project Settings, NeuronMocap.";

        // By number: Unity 2021.3 and early versions of 2022.3 do not have its name.
        private const BuildTarget VisionOS = (BuildTarget)47;

        // Builds that are an Xcode project whose Info.plist holds the text. macOS asks without a text; a build for it is signed, and a change of its
        // Info.plist would break the signature.
        public static bool AsksForLocalNetwork(BuildTarget target) => target is BuildTarget.iOS or BuildTarget.tvOS or VisionOS;

        public static string WebGLAdvice(string source, string scene) =>
            $"NeuronMocap: the source on '{source}' in scene '{scene}' receives nothing in a WebGL build: browsers allow neither TCP nor UDP sockets, "
            + $"nor threads. For alternatives, see {PlatformsPage}.";

        // Applies to the whole build. isForced: the player setting. manifest: the project's own manifest, or null.
        public static bool LacksInternetPermission(bool isForced, string? manifest) =>
            !isForced && (manifest is null || !AndroidManifest.HasInternetPermission(manifest));
    }
}
