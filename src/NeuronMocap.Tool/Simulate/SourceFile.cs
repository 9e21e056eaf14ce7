using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Simulate;

/// <summary>Describes faults of a file that an option names, before and during reading.</summary>
internal static class SourceFile
{
    /// <summary>Reads a file.</summary>
    /// <param name="option">The option that names the file.</param>
    /// <param name="file">The file.</param>
    /// <param name="read">Reads the file.</param>
    /// <exception cref="SimulatorException">The file cannot be read, or has another format. The message says why.</exception>
    public static T Read<T>(string option, FileInfo file, Func<T> read)
    {
        try
        {
            Check(option, file);
            return read();
        }
        catch (NeuronException exception)
        {
            throw new SimulatorException($"{option}: {FileFault.WithName(exception.Message, file.ToString())}{SuggestOption(option, file)}");
        }
        catch (UnauthorizedAccessException)
        {
            throw new SimulatorException($"{option}: '{file}' cannot be read: this user has no permission.");
        }
        catch (IOException exception)
        {
            throw new SimulatorException($"{option}: {FileFault.OfReading(exception, file.ToString())}");
        }
    }

    // The file may be of a kind that another option plays.
    private static string SuggestOption(string option, FileInfo file)
    {
        try
        {
            string fitting = FileKinds.Recognize(file.FullName) switch
            {
                FileKind.Bvh => "--bvh",
                FileKind.Calculation => "--calc",
                _ => "--play",
            };
            return fitting.Equals(option, StringComparison.Ordinal) ? string.Empty : $" {fitting} plays this file.";
        }
        catch (Exception exception) when (exception is NeuronException or IOException or UnauthorizedAccessException)
        {
            return string.Empty;
        }
    }

    private static void Check(string option, FileInfo file)
    {
        if (InputFile.FindOddKind(file.FullName) is { } kind)
            throw new SimulatorException($"{option}: '{file}' is {kind}; only regular files are read.");

        FileSystemInfo? target = file.Exists ? file.ResolveLinkTarget(returnFinalTarget: true) ?? file : null;
        if (target is not FileInfo { Exists: true } content)
            throw new SimulatorException($"{option}: '{file}' does not exist.");
        if (content.Length == 0)
            throw new SimulatorException($"{option}: '{file}' is empty.");
    }
}
