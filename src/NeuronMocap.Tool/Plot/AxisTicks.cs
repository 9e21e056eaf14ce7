using System.Globalization;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Plot;

/// <summary>Round numbers along an axis. The step is 1, 2 or 5 times a power of ten.</summary>
internal static class AxisTicks
{
    // No axis has room for more.
    private const int MaxTicks = 100;

    private const double LargestPlainLabel = 1e7;

    // Files with absurd frame times can last longer than a TimeSpan can hold.
    private const double LongestClockTime = 1e9;

    /// <summary>Finds the smallest round step with at most a given number of ticks in a range.</summary>
    public static double Step(double range, int most)
    {
        double raw = range / Math.Max(most, 1);
        double power = Math.Pow(10, Math.Floor(Math.Log10(raw)));
        if (!(power > 0) || !double.IsFinite(power))
            return 1;

        double step = (raw / power) switch
        {
            <= 1.000001 => 1,
            <= 2.000001 => 2,
            <= 5.000001 => 5,
            _ => 10,
        };
        return step * power;
    }

    /// <summary>Finds the step for seconds. Here 15, 30 and 60 are round numbers, too.</summary>
    public static double StepOfTime(double seconds, int most)
    {
        ReadOnlySpan<double> usual = [15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 21600, 43200, 86400];
        double step = Step(seconds, most);
        if (step <= 10)
            return step;

        foreach (double candidate in usual)
        {
            if (seconds / candidate <= most)
                return candidate;
        }

        return step;
    }

    /// <summary>Gets the multiples of a step in a range. Empty if the range is so far from zero that its ends are the same number.</summary>
    public static IEnumerable<double> Between(double from, double to, double step)
    {
        double first = Math.Ceiling((from / step) - 1e-6);
        double count = Math.Floor((to / step) + 1e-6) - first + 1;
        if (!(count <= MaxTicks) || first + 1 == first)
            yield break;

        for (int i = 0; i < count; i++)
            yield return (first + i) * step;
    }

    /// <summary>Formats a number of an axis with as many decimals as its step.</summary>
    public static string Label(double value, double step)
    {
        if (Math.Max(Math.Abs(value), step) >= LargestPlainLabel)
            return value.ToString("0.###e0", CultureInfo.InvariantCulture).Replace('-', '−');

        int decimals = Math.Clamp((int)Math.Ceiling(-Math.Log10(step) - 1e-6), 0, 15);
        double rounded = Math.Round(value, decimals);
        return Math.Abs(rounded).ToString($"F{decimals}", CultureInfo.InvariantCulture) is var text && rounded < 0 ? "−" + text : text;
    }

    /// <summary>Formats seconds for a time axis: 12.5, or 2:30 and 1:02:30 if the step divides minutes.</summary>
    public static string TimeLabel(double seconds, double step)
    {
        if (step <= 10 || seconds > LongestClockTime)
            return Label(seconds, step);

        var time = TimeSpan.FromSeconds(Math.Round(seconds));
        return time.TotalHours >= 1
            ? Quantity.Format($"{(int)time.TotalHours}:{time.Minutes:00}:{time.Seconds:00}")
            : Quantity.Format($"{time.Minutes}:{time.Seconds:00}");
    }
}
