#nullable enable

using System.IO;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // The location of a source's file. Main thread.
    internal static class SourceFiles
    {
        // Absolute paths are used as they are. Other paths are in StreamingAssets, which on Android is inside the application package and not a
        // folder.
        public static string Resolve(string file)
        {
            file = file.Trim();
            return file.Length == 0 || Path.IsPathRooted(file) ? file : Path.Combine(Application.streamingAssetsPath, file);
        }

        public static string NameOf(string file) => Path.GetFileNameWithoutExtension(file);
    }
}
