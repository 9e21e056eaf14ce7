namespace NeuronMocap.Monitor.Files;

/// <summary>
/// A file that is written beside its place and comes there when it is whole: what was there before stays until then, and a run that ends early
/// leaves nothing.
/// </summary>
internal sealed class OutputFile : IDisposable
{
    private readonly string _path;
    private readonly bool _overwrite;
    private bool _isKept;

    /// <summary>Finds a place for the file.</summary>
    /// <exception cref="IOException">It is there already and must not be replaced.</exception>
    public OutputFile(string path, bool overwrite)
    {
        if (Directory.Exists(path))
            throw new IOException($"'{path}' is a folder.");
        if (!overwrite && File.Exists(path))
            throw new IOException($"'{path}' is there already; --overwrite replaces it.");

        _path = path;
        _overwrite = overwrite;
        TemporaryPath = $"{path}.{Environment.ProcessId}.part{Path.GetExtension(path)}";
    }

    /// <summary>Where to write.</summary>
    public string TemporaryPath { get; }

    /// <summary>Puts the file, which nobody has open any more, into its place.</summary>
    /// <exception cref="IOException">In the meantime there is another one, which must not be replaced.</exception>
    public void Keep()
    {
        File.Move(TemporaryPath, _path, _overwrite);
        _isKept = true;
    }

    public void Dispose()
    {
        if (!_isKept)
            File.Delete(TemporaryPath);
    }
}
