#nullable enable
using System;
using System.Globalization;
using System.IO;
using System.Text;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Creates names of recorded files from a pattern. The placeholders are <c>{source}</c>, <c>{date}</c> (2024-05-31), <c>{time}</c> (14-03-59) and
    /// <c>{take}</c> (001, the first free number). Characters that file names cannot contain become hyphens.
    /// </summary>
    public static class TakeFileName
    {
        /// <summary>The default pattern of a recorder.</summary>
        public const string DefaultPattern = "{source} {date} {time}";

        private const string TakeToken = "{take}";
        private const int MaxTakes = 9999;

        // Forbidden on any system, not only on this one, because takes are copied between systems.
        private const string Forbidden = "<>:\"/\\|?*";

        /// <summary>Creates a name that no file of the folder has, with any of the extensions.</summary>
        /// <param name="folder">The folder of the files.</param>
        /// <param name="pattern">The pattern, without extension. Empty: <see cref="DefaultPattern"/>.</param>
        /// <param name="source">The value of <c>{source}</c>.</param>
        /// <param name="now">The time to write.</param>
        /// <param name="extensions">Extensions that must be free, with their dots.</param>
        /// <returns>The path without extension.</returns>
        /// <exception cref="IOException">The folder already has 9999 takes of that name.</exception>
        public static string Create(string folder, string pattern, string source, DateTime now, params string[] extensions)
        {
            string named = Expand(string.IsNullOrWhiteSpace(pattern) ? DefaultPattern : pattern, source, now);
            bool hasTake = named.Contains(TakeToken);
            for (int take = 1; take <= MaxTakes; take++)
            {
                string number = take.ToString("000", CultureInfo.InvariantCulture);
                string name = hasTake ? named.Replace(TakeToken, number) : take == 1 ? named : named + " " + number;
                string path = Path.Combine(folder, Clean(name));
                if (IsFree(path, extensions))
                    return path;
            }

            throw new IOException($"The folder \"{folder}\" already has {MaxTakes} takes of this name. Choose another file name.");
        }

        private static string Expand(string pattern, string source, DateTime now) => pattern
            .Replace("{source}", source)
            .Replace("{date}", now.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture))
            .Replace("{time}", now.ToString("HH-mm-ss", CultureInfo.InvariantCulture));

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
