#nullable enable

namespace NeuronMocap.Unity.EditorTools
{
    // What the checks say, in one place, apart from the editor calls that find it out.
    internal static class BuildRules
    {
        public const string PlatformsPage = "the page 'Platforms' of the package's documentation (Documentation~/platforms.md)";

        public const string MissingTextAdvice =
            "NeuronMocap: the text for iOS's question about the local network is empty. Without one iOS 14 and newer answer every connection in "
            + "the local network with 'no route'. Write one in Edit, Project Settings, NeuronMocap.";

        public const string TextNotAddedAdvice =
            "NeuronMocap: the Info.plist has no " + InfoPlist.LocalNetworkKey + ", and adding one is off in Edit, Project Settings, NeuronMocap. "
            + "Without it iOS 14 and newer answer every connection in the local network with 'no route'.";

        public const string PermissionAdvice =
            "NeuronMocap: this Android build may lack the permission for the network, without which no source receives anything. Set Internet "
            + "Access to Require in the Android player settings, or switch 'Require Internet Permission' on in Edit, Project Settings, NeuronMocap.";

        public const string PermissionSet =
            "NeuronMocap: Internet Access of the Android player settings is now Require, so that sources can receive. "
            + "Edit, Project Settings, NeuronMocap switches this off.";

        public static string WebGLAdvice(string source, string scene) =>
            $"NeuronMocap: the source on '{source}' in scene '{scene}' receives nothing in a WebGL build: browsers allow neither TCP nor UDP sockets "
            + $"nor threads. What to do instead says {PlatformsPage}.";

        // Of the build as a whole. isForced: the player setting; manifest: the project's own, null when there is none.
        public static bool LacksInternetPermission(bool isForced, string? manifest) =>
            !isForced && (manifest is null || !AndroidManifest.HasInternetPermission(manifest));
    }
}
