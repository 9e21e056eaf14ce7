using System.CommandLine.Parsing;

namespace NeuronMocap.Tool.Arguments;

/// <summary>Parses the rotation order of an option. If it is wrong, returns null and adds an error that lists all orders.</summary>
internal static class RotationOrderArgument
{
    public static RotationOrder? Parse(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        foreach (RotationOrder order in Enum.GetValues<RotationOrder>())
        {
            if (order.ToString().Equals(text, StringComparison.OrdinalIgnoreCase))
                return order;
        }

        result.AddError($"{((OptionResult)result.Parent!).Option.Name}: '{text}' is not one of {string.Join(", ", Enum.GetNames<RotationOrder>())}.");
        return null;
    }
}
