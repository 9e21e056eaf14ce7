#nullable enable

using System;
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace NeuronMocap.Unity.EditorTools
{
    // What keeps data from arriving on a device is said, or set right, when the build is made, and not found out on the device.
    internal sealed class BuildChecks : IPreprocessBuildWithReport, IProcessSceneWithReport, IPostprocessBuildWithReport
    {
        // After the post-processing of others, whose text for the local network then stays.
        public int callbackOrder => 1000;

        public void OnPreprocessBuild(BuildReport report)
        {
            if (report.summary.platform == BuildTarget.Android)
                CheckAndroid(NeuronMocapSettings.instance);
        }

        // Also called when a scene is entered in the editor's play mode, then without a report.
        public void OnProcessScene(Scene scene, BuildReport? report)
        {
            BuildProblem wanted = NeuronMocapSettings.instance.WebGL;
            if (report is null || report.summary.platform != BuildTarget.WebGL || wanted == BuildProblem.Ignore)
                return;

            foreach (MocapSource source in scene.GetRootGameObjects().SelectMany(root => root.GetComponentsInChildren<MocapSource>(true)))
            {
                string advice = BuildRules.WebGLAdvice(source.name, scene.name);
                if (wanted == BuildProblem.Fail)
                    throw new BuildFailedException(advice);

                Debug.LogWarning(advice, source);
            }
        }

        public void OnPostprocessBuild(BuildReport report)
        {
            if (report.summary.platform == BuildTarget.iOS)
                AddLocalNetworkText(Path.Combine(report.summary.outputPath, "Info.plist"), NeuronMocapSettings.instance);
        }

        internal static void CheckAndroid(NeuronMocapSettings settings)
        {
            string? manifest = File.Exists(AndroidManifest.CustomPath) ? File.ReadAllText(AndroidManifest.CustomPath) : null;
            if (!BuildRules.LacksInternetPermission(PlayerSettings.Android.forceInternetPermission, manifest))
                return;

            if (!settings.RequireInternetPermission)
            {
                Debug.LogWarning(BuildRules.PermissionAdvice);
                return;
            }

            PlayerSettings.Android.forceInternetPermission = true;
            Debug.Log(BuildRules.PermissionSet);
        }

        internal static void AddLocalNetworkText(string path, NeuronMocapSettings settings)
        {
            try
            {
                string before = File.ReadAllText(path);
                if (InfoPlist.HasLocalNetworkText(before))
                    return;

                if (!settings.AddLocalNetworkText || string.IsNullOrWhiteSpace(settings.LocalNetworkText))
                {
                    Debug.LogWarning(settings.AddLocalNetworkText ? BuildRules.MissingTextAdvice : BuildRules.TextNotAddedAdvice);
                    return;
                }

                File.WriteAllText(path, InfoPlist.WithLocalNetworkText(before, settings.LocalNetworkText.Trim()));
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException or FormatException)
            {
                Debug.LogError($"NeuronMocap: {InfoPlist.LocalNetworkKey} could not be put into {path}: {exception.Message} Add it in Xcode, or the "
                    + "app gets no data from the local network.");
            }
        }
    }
}
