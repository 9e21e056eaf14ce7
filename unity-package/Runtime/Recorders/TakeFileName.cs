#nullable enable
using System;
using System.IO;
using System.Text;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Creates names of recorded files from a pattern. The placeholders are <c>{source}</c>, <c>{name}</c>, <c>{date}</c> (2024-05-31), <c>{time}</c>
    /// (14-03-59) and <c>{take}</c> (001, the first free number). Characters that file names cannot contain become hyphens.
    /// </summary>
    public static class TakeFileName
    {
        /// <summary>The default pattern of a recorder.</summary>
        public const string DefaultPattern = "{source} {name} {take}";

        private const int MaxTakes = 9999;

        // Forbidden on any system, not only on this one, because takes are copied between systems.
        private const string Forbidden = "<>:\"/\\|?*";

        /// <summary>Creates a name that no file of the folder has, with any of the extensions. <c>{name}</c> becomes <c>Take</c>.</summary>
        /// <param name="folder">The folder of the files.</param>
        /// <param name="pattern">The pattern, without extension. Empty: <see cref="DefaultPattern"/>.</param>
        /// <param name="source">The value of <c>{source}</c>.</param>
        /// <param name="now">The time to write.</param>
        /// <param name="extensions">Extensions that must be free, with their dots.</param>
        /// <returns>The path without extension.</returns>
        /// <exception cref="IOException">The folder already has 9999 takes of that name.</exception>
        public static string Create(string folder, string pattern, string source, DateTime now, params string[] extensions) =>
            new TakeLabel(pattern, source, TakeLabel.DefaultName, 1, now).Create(folder, extensions);

        // nameOf: the name after so many names that were not free.
        internal static (string Path, int Tries) FindFree(string folder, Func<int, string> nameOf, string[] extensions)
        {
            for (int tries = 0; tries < MaxTakes; tries++)
            {
                string path = Path.Combine(folder, Clean(nameOf(tries)));
                if (IsFree(path, extensions))
                    return (path, tries);
            }

            throw new IOException($"The folder \"{folder}\" already has {MaxTakes} takes of this name. Choose another file name.");
        }

        private static string Clean(string name)
        {
            var clean = new StringBuilder(name.Length);
            foreach (char letter in name)
                clean.Append(letter < ' ' || Forbidden.IndexOf(letter) >= 0 ? '-' : letter);

            // Windows removes dots and blanks at the end, which could make two names equal.
            string trimmed = clean.ToString().Trim().TrimEnd('.', ' ');
            return trimmed.Length == 0 ? "take" : trimmed;
        }

        // The files of several avatars, or of parts of a take, have a suffix after the name.
        private static bool IsFree(string path, string[] extensions)
        {
            string folder = Path.GetDirectoryName(path) ?? "";
            if (!Directory.Exists(folder))
                return true;

            foreach (string extension in extensions)
            {
                if (File.Exists(path + extension) || Directory.GetFiles(folder, Path.GetFileName(path) + "-*" + extension).Length > 0)
                    return false;
            }

            return true;
        }
    }
}
