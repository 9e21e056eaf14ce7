#nullable enable

using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    /// <summary>
    /// What the project wants of its builds: Edit, Project Settings, NeuronMocap. Kept in ProjectSettings/NeuronMocap.asset, which belongs
    /// into version control. Main thread only.
    /// </summary>
    [FilePath("ProjectSettings/NeuronMocap.asset", FilePathAttribute.Location.ProjectFolder)]
    public sealed class NeuronMocapSettings : ScriptableSingleton<NeuronMocapSettings>
    {
        /// <summary>The text that iOS shows unless another one is set.</summary>
        public const string DefaultLocalNetworkText = "Receives motion capture data from a computer in your network.";

        [SerializeField, Tooltip("iOS 14 and newer ask the user, with this text, before an app may talk to other computers on the network. "
            + "A text that is in the Info.plist already stays.")]
        private bool _addLocalNetworkText = true;

        [SerializeField, TextArea(2, 4), Tooltip("Why the app needs the local network, in words for the user of the device.")]
        private string _localNetworkText = DefaultLocalNetworkText;

        [SerializeField, Tooltip("Sets Internet Access to Require in the Android player settings when a build begins. Without that "
            + "permission every connection fails on the device.")]
        private bool _requireInternetPermission = true;

        [SerializeField, Tooltip("What to do when a scene with a source is built for WebGL: browsers do not allow TCP or UDP sockets.")]
        private BuildProblem _webGL = BuildProblem.Warn;

        /// <summary>Whether the text for the local network is put into the Info.plist of an iOS build. On unless set.</summary>
        public bool AddLocalNetworkText
        {
            get => _addLocalNetworkText;
            set => _addLocalNetworkText = value;
        }

        /// <summary>The text that iOS shows when it asks whether the app may use the local network.</summary>
        public string LocalNetworkText
        {
            get => _localNetworkText;
            set => _localNetworkText = value ?? string.Empty;
        }

        /// <summary>Whether an Android build switches the permission for the network on. On unless set.</summary>
        public bool RequireInternetPermission
        {
            get => _requireInternetPermission;
            set => _requireInternetPermission = value;
        }

        /// <summary>What happens when a scene with a source is built for WebGL: a warning unless set.</summary>
        public BuildProblem WebGL
        {
            get => _webGL;
            set => _webGL = value;
        }

        /// <summary>Writes the settings to their file.</summary>
        public void Save() => Save(true);
    }
}
