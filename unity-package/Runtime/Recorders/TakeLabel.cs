#nullable enable
using System;
using System.Globalization;

namespace NeuronMocap.Unity
{
    // What the name of a take is made of. It is completed on another thread, because that looks into the folder.
    internal sealed class TakeLabel
    {
        public const string DefaultName = "Take";

        private const string TakeToken = "{take}";

        private readonly string _text;
        private readonly int _slate;
        private volatile int _number;

        // pattern: as for TakeFileName. slate: the first number to try.
        public TakeLabel(string pattern, string source, string name, int slate, DateTime now)
        {
            string trimmed = name.Trim();
            _slate = Math.Max(1, slate);
            _text = (string.IsNullOrWhiteSpace(pattern) ? TakeFileName.DefaultPattern : pattern)
                .Replace("{source}", source)
                .Replace("{name}", trimmed.Length == 0 ? DefaultName : trimmed)
                .Replace("{date}", now.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture))
                .Replace("{time}", now.ToString("HH-mm-ss", CultureInfo.InvariantCulture));
        }

        // The number of the take, or 0 until its files have a name. Any thread.
        public int Number => _number;

        // The name in an empty folder.
        public string First => NameOf(0);

        // Any thread.
        public string Create(string folder, params string[] extensions)
        {
            (string path, int tries) = TakeFileName.FindFree(folder, NameOf, extensions);
            _number = _text.Contains(TakeToken) ? _slate + tries : _slate;
            return path;
        }

        // Without {take}, only names that are not free get a number.
        private string NameOf(int tries) => _text.Contains(TakeToken) ? _text.Replace(TakeToken, Format(_slate + tries))
            : tries == 0 ? _text : $"{_text} {Format(tries + 1)}";

        private static string Format(int number) => number.ToString("000", CultureInfo.InvariantCulture);
    }
}
