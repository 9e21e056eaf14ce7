#nullable enable
using System;
#if !UNITY_6000_1_OR_NEWER
using System.Reflection;
#endif
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // Saves the takes of clip recorders as assets.
    [InitializeOnLoad]
    internal static class ClipSaver
    {
        private const string Assets = "Assets";
        private const string Extension = ".anim";

        static ClipSaver() => Register();

        internal static void Register()
        {
            ClipRecorder.Saver = Save;
            ClipTake.Writer = (take, keyTolerance) => ClipWriter.Create(take, keyTolerance);
#if !UNITY_6000_1_OR_NEWER
            if (typeof(Avatar).GetMethod("GetPostRotation", BindingFlags.Instance | BindingFlags.NonPublic) is { } getAxes)
                HumanoidGoals.AxesOf = (avatar, bone) => (Quaternion)getAxes.Invoke(avatar, new object[] { (int)bone });
#endif
        }

        private static string Save(ClipRecorder recorder, ClipTake take)
        {
            string folder = MakeFolder(recorder.Folder);
            string character = recorder.Animator != null ? recorder.Animator.name : recorder.name;
            string wanted = recorder.Label(character).Create(folder, Extension).Replace('\\', '/') + Extension;
            string path = AssetDatabase.GenerateUniqueAssetPath(wanted);
            try
            {
                AnimationClip clip = ClipWriter.Create(
                    take, recorder.KeyTolerance, part => EditorUtility.DisplayProgressBar("Writing an animation clip", path, part));
                AssetDatabase.CreateAsset(clip, path);
                AssetDatabase.SaveAssets();
            }
            finally
            {
                EditorUtility.ClearProgressBar();
            }

            Debug.Log(FormattableString.Invariant($"Animation clip saved: {path} ({take.FrameCount} frames, {take.Length:0.0} s)"), recorder);
            return path;
        }

        // The asset database creates one level at a time.
        private static string MakeFolder(string below)
        {
            string folder = Assets;
            foreach (string part in below.Split(new[] { '/', '\\' }, StringSplitOptions.RemoveEmptyEntries))
            {
                if (Is(part, "..") || Is(part, "."))
                    throw new ArgumentException($"The folder \"{below}\" is not below Assets.", nameof(below));
                if (Is(part, Assets) && Is(folder, Assets))
                    continue;

                string next = folder + "/" + part;
                if (!AssetDatabase.IsValidFolder(next))
                    AssetDatabase.CreateFolder(folder, part);

                folder = next;
            }

            return folder;
        }

        private static bool Is(string text, string other) => string.Equals(text, other, StringComparison.Ordinal);
    }
}
