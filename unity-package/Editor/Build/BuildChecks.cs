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
    // Finds or corrects problems that would keep data from arriving on a device when the build is made.
    internal sealed class BuildChecks : IPreprocessBuildWithReport, IProcessSceneWithReport, IPostprocessBuildWithReport
    {
        // Runs after the post-processing of others, so their text for the local network stays.
        public int callbackOrder => 1000;

        public void OnPreprocessBuild(BuildReport report)
        {
            if (report.summary.platform == BuildTarget.Android)
                CheckAndroid(NeuronMocapSettings.instance);
        }

        // Also called when a scene enters play mode in the editor. The report is then null.
        public void OnProcessScene(Scene scene, BuildReport? report)
        {
            if (report is null)
                return;

            BuildMaterials.Add(scene);
            BuildProblem wanted = NeuronMocapSettings.instance.WebGL;
            if (report.summary.platform != BuildTarget.WebGL || wanted == BuildProblem.Ignore)
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
            if (BuildRules.AsksForLocalNetwork(report.summary.platform))
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
                Debug.LogError($"NeuronMocap: {InfoPlist.LocalNetworkKey} could not be added to {path}: {exception.Message} Add it in Xcode. Without it the "
                    + "app receives no data from the local network.");
            }
        }
    }
}
