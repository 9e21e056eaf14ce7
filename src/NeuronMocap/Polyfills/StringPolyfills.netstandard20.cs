using System.Text;

namespace NeuronMocap.Polyfills;

// Members of strings that netstandard2.0 lacks. Those that take a comparison are only called with the ordinal ones.
internal static class StringPolyfills
{
    extension(string)
    {
        public static string Join<T>(char separator, IEnumerable<T> values) => string.Join(separator.ToString(), values);
    }

    public static bool Contains(this string text, string value, StringComparison comparison) => text.IndexOf(value, comparison) >= 0;

    public static bool Contains(this string text, char value, StringComparison comparison) => text.IndexOf(value, comparison) >= 0;

    public static int IndexOf(this string text, char value, StringComparison comparison) => text.IndexOf(value.ToString(), comparison);

    public static bool StartsWith(this string text, char value) => text.Length > 0 && text[0] == value;

    public static bool EndsWith(this string text, char value) => text.Length > 0 && text[^1] == value;

    public static string Replace(this string text, string oldValue, string newValue, StringComparison comparison)
    {
        var result = new StringBuilder();
        int start = 0;
        for (int i; (i = text.IndexOf(oldValue, start, comparison)) >= 0; start = i + oldValue.Length)
            result.Append(text, start, i - start).Append(newValue);

        return result.Append(text, start, text.Length - start).ToString();
    }
}
