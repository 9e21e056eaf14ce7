using NeuronMocap.Compatibility;

namespace NeuronMocap.Native;

// For programs that nobody can compile again: the environment chooses the layout of frames' headers.
internal static class HeaderVariable
{
    private const string Name = "NEURONDATAREADER_HEADER";
    private const string Old = "b12";

    // Read once, at the first call: a receive thread that read it would race with programs that set variables.
    public static HeaderLayout Read()
    {
        string? value = Environment.GetEnvironmentVariable(Name);
        if (string.Equals(value, Old, StringComparison.Ordinal))
            return HeaderLayout.Old;

        if (!string.IsNullOrEmpty(value))
            LastError.Set($"{Name} is '{value}'; it has to be '{Old}' or not set.");

        return HeaderLayout.New;
    }
}
