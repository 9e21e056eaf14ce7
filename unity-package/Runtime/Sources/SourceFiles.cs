#nullable enable

using System.IO;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // Where a source's file is. Main thread.
    internal static class SourceFiles
    {
        // Absolute paths as they are; others are in StreamingAssets, which on Android is a place within a package and no folder.
        public static string Resolve(string file)
        {
            file = file.Trim();
            return file.Length == 0 || Path.IsPathRooted(file) ? file : Path.Combine(Application.streamingAssetsPath, file);
        }

        public static string NameOf(string file) => Path.GetFileNameWithoutExtension(file);
    }
}
