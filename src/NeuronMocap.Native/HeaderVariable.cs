using NeuronMocap.Compatibility;

namespace NeuronMocap.Native;

// For programs that cannot be recompiled: an environment variable sets the layout of the frame headers.
internal static class HeaderVariable
{
    private const string Name = "NEURONDATAREADER_HEADER";
    private const string Old = "b12";

    // Read once, at the first call. Reading it on a receive thread would race with programs that set variables.
    public static HeaderLayout Read()
    {
        string? value = Environment.GetEnvironmentVariable(Name);
        if (string.Equals(value, Old, StringComparison.Ordinal))
            return HeaderLayout.Old;

        if (!string.IsNullOrEmpty(value))
            LastError.Set($"{Name} is '{value}'; it must be '{Old}' or not set.");

        return HeaderLayout.New;
    }
}
