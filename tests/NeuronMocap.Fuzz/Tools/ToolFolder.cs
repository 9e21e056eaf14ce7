namespace NeuronMocap.Fuzz.Tools;

/// <summary>A folder of this run, in which the file tools read and write. It is deleted with the program.</summary>
internal sealed class ToolFolder
{
    private readonly string _folder = Directory.CreateTempSubdirectory("neuronmocap-fuzz-").FullName;

    public ToolFolder()
    {
        Input = Path.Combine(_folder, "take.in");
        AppDomain.CurrentDomain.ProcessExit += (_, _) => Remove();
    }

    /// <summary>The file to read.</summary>
    public string Input { get; }

    /// <summary>Returns the bytes of all files except the input. Any thread.</summary>
    public long CountOutput()
    {
        long count = 0;
        try
        {
            foreach (FileInfo file in new DirectoryInfo(_folder).EnumerateFiles())
                count += string.Equals(file.FullName, Input, StringComparison.Ordinal) ? 0 : file.Length;
        }
        catch (IOException)
        {
            // A file was deleted in between.
        }

        return count;
    }

    public string OutputPath(string extension) => Path.Combine(_folder, "take" + extension);

    /// <summary>Deletes the output.</summary>
    /// <returns>The number of files that are not output: a tool left them over.</returns>
    public int CleanUp(string? output)
    {
        int others = 0;
        foreach (string path in Directory.EnumerateFiles(_folder))
        {
            if (string.Equals(path, Input, StringComparison.Ordinal))
                continue;

            others += string.Equals(path, output, StringComparison.Ordinal) ? 0 : 1;
            File.Delete(path);
        }

        return others;
    }

    private void Remove()
    {
        try
        {
            Directory.Delete(_folder, recursive: true);
        }
        catch (IOException)
        {
            // An input that did not end still writes.
        }
    }
}
