#nullable enable

using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    /// <summary>
    /// The project's build settings, shown in Edit, Project Settings, NeuronMocap. They are stored in ProjectSettings/NeuronMocap.asset, which should
    /// be under version control. Use this type on the main thread only.
    /// </summary>
    [FilePath("ProjectSettings/NeuronMocap.asset", FilePathAttribute.Location.ProjectFolder)]
    public sealed class NeuronMocapSettings : ScriptableSingleton<NeuronMocapSettings>
    {
        /// <summary>The default text that the device shows.</summary>
        public const string DefaultLocalNetworkText = "Receives motion capture data from a computer in your network.";

        [SerializeField, Tooltip("Add the text below to the Info.plist. iOS, tvOS and visionOS show it when they ask the user whether an app may talk to other "
            + "computers on the network. A text already in the Info.plist stays.")]
        private bool _addLocalNetworkText = true;

        [SerializeField, TextArea(2, 4), Tooltip("Why the app needs the local network, in words for the user of the device.")]
        private string _localNetworkText = DefaultLocalNetworkText;

        [SerializeField, Tooltip("Sets Internet Access to Require in the Android player settings when a build begins. Without that "
            + "permission, every connection fails on the device.")]
        private bool _requireInternetPermission = true;

        [SerializeField, Tooltip("What to do when a scene with a source is built for WebGL: browsers do not allow TCP or UDP sockets.")]
        private BuildProblem _webGL = BuildProblem.Warn;

        /// <summary>Gets or sets whether the text for the local network is added to the Info.plist of a build for iOS, tvOS or visionOS. On by default.</summary>
        public bool AddLocalNetworkText
        {
            get => _addLocalNetworkText;
            set => _addLocalNetworkText = value;
        }

        /// <summary>Gets or sets the text that the device shows when it asks whether the app may use the local network.</summary>
        public string LocalNetworkText
        {
            get => _localNetworkText;
            set => _localNetworkText = value ?? string.Empty;
        }

        /// <summary>Gets or sets whether an Android build switches the network permission on. On by default.</summary>
        public bool RequireInternetPermission
        {
            get => _requireInternetPermission;
            set => _requireInternetPermission = value;
        }

        /// <summary>Gets or sets what happens when a scene with a source is built for WebGL. The default is a warning.</summary>
        public BuildProblem WebGL
        {
            get => _webGL;
            set => _webGL = value;
        }

        /// <summary>Writes the settings to their file.</summary>
        public void Save() => Save(true);
    }
}
