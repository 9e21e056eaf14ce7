#nullable enable

using System;
using System.IO;
using UnityEditor;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The dialog that chooses a motion file.
    internal static class MotionFilePanel
    {
        // Sets a field to the chosen file. A cancelled dialog changes nothing. extensions: with commas between them.
        public static void Choose(SerializedProperty file, string extensions)
        {
            string chosen = EditorUtility.OpenFilePanelWithFilters("Motion", Application.streamingAssetsPath, new[] { "Motion", extensions });
            if (chosen.Length > 0)
                file.stringValue = ToFieldText(chosen, Application.streamingAssetsPath);
        }

        // Paths relative to StreamingAssets stay valid when the project moves, and in builds.
        internal static string ToFieldText(string path, string streamingAssets)
        {
            string full = Path.GetFullPath(path);
            string folder = Path.GetFullPath(streamingAssets) + Path.DirectorySeparatorChar;
            return full.StartsWith(folder, StringComparison.Ordinal) ? full.Substring(folder.Length).Replace('\\', '/') : path;
        }
    }
}
