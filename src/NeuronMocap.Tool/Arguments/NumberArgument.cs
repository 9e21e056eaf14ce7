using System.CommandLine.Parsing;
using System.Globalization;

namespace NeuronMocap.Tool.Arguments;

/// <summary>Parses the number of an option. If it is wrong, returns null and adds an error with the expected value.</summary>
internal static class NumberArgument
{
    public static double? Parse(ArgumentResult result, double least, double most, string expected) =>
        double.TryParse(TextOf(result), NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double number) && number >= least && number <= most
            ? number
            : Reject<double>(result, expected);

    public static int? ParseWhole(ArgumentResult result, int least, int most, string expected) =>
        int.TryParse(TextOf(result), NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number >= least && number <= most
            ? number
            : Reject<int>(result, expected);

    private static string TextOf(ArgumentResult result) => result.Tokens[0].Value;

    private static T? Reject<T>(ArgumentResult result, string expected)
        where T : struct
    {
        result.AddError($"{((OptionResult)result.Parent!).Option.Name}: '{TextOf(result)}' is not {expected}.");
        return null;
    }
}
