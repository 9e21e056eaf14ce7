using System.Globalization;

namespace NeuronMocap.Tool.Terminal;

/// <summary>Formats readable numbers with few characters.</summary>
internal static class Quantity
{
    public static string Bytes(double bytes) => bytes switch
    {
        < 1000 => Format($"{bytes:0} B"),
        < 1e6 => Format($"{bytes / 1e3:0.0} kB"),
        < 1e9 => Format($"{bytes / 1e6:0.0} MB"),
        _ => Format($"{bytes / 1e9:0.0} GB"),
    };

    /// <summary>Formats the size of memory, in powers of 1024.</summary>
    public static string Memory(double bytes) => bytes switch
    {
        < 1024 => Format($"{bytes:0} B"),
        < 1024 * 1024 => Format($"{bytes / 1024:0.#} KiB"),
        _ => Format($"{bytes / (1024 * 1024):0.#} MiB"),
    };

    public static string Duration(TimeSpan time) => time.TotalSeconds switch
    {
        < 1 => Format($"{Math.Max(time.TotalMilliseconds, 0):0} ms"),
        < 60 => Format($"{time.TotalSeconds:0.0} s"),
        < 3600 => Format($"{time.Minutes} min {time.Seconds:00} s"),
        _ => Format($"{(int)time.TotalHours} h {time.Minutes:00} min"),
    };

    public static string Age(TimeSpan time) => time.TotalSeconds switch
    {
        < 60 => Duration(time),
        < 3600 => Format($"{time.Minutes} min"),
        _ => Format($"{(int)time.TotalHours} h"),
    };

    public static string Count(long number) => Format($"{number:#,0}");

    /// <summary>Formats a number and what it counts: "1 frame", "2,000 frames".</summary>
    public static string Count(long number, string noun, string? plural = null) => $"{Count(number)} {Noun(number, noun, plural)}";

    /// <summary>Gets the noun that follows a number: "frame" after 1, and "frames" after all others.</summary>
    public static string Noun(long number, string noun, string? plural = null) => number == 1 ? noun : plural ?? noun + "s";

    public static string Fixed(double value, int decimals)
    {
        double rounded = Math.Round(value, decimals);
        return (rounded == 0 ? 0 : rounded).ToString(decimals == 0 ? "0" : "0.0", CultureInfo.InvariantCulture);
    }

    public static string Format(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
