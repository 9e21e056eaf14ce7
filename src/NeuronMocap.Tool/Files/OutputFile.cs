namespace NeuronMocap.Tool.Files;

/// <summary>A file that is written under a temporary name and renamed when it is complete.</summary>
/// <remarks>
/// An existing file stays until then, and a run that ends early leaves nothing. A symbolic link stays, and its target is replaced. On Linux
/// and macOS, the complete file gets the permission bits of the one that it replaces. Thread-safe, so that a run can be abandoned while a thread still writes.
/// </remarks>
/// <param name="path">The final path.</param>
/// <param name="overwrite">Whether an existing file is replaced.</param>
internal sealed class OutputFile(string path, bool overwrite) : IDisposable
{
    private readonly Lock _lock = new();

    // The path, or what it links to.
    private string? _target;
    private UnixFileMode? _mode;
    private bool _isGivenUp;
    private bool _isBegun;

    /// <summary>Writes the file and moves it to its final path.</summary>
    /// <param name="write">Writes a file at the path that it receives, and closes it.</param>
    /// <exception cref="IOException">The file exists and must not be replaced, or it cannot be written.</exception>
    /// <exception cref="OperationCanceledException">The run was abandoned.</exception>
    public void Write(Action<string> write)
    {
        Check();
        try
        {
            lock (_lock)
            {
                Begin();
            }

            write(TemporaryPath);
            Keep();
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException && exception.Message.Contains(Path.GetFileName(TemporaryPath), StringComparison.Ordinal))
        {
            // The message names the final path, because users do not know the temporary name.
            throw new IOException(FileFault.OfWriting(exception, _target ?? path), exception);
        }
        finally
        {
            Dispose();
        }
    }

    /// <summary>Deletes the temporary file if the file is not complete.</summary>
    public void Dispose()
    {
        lock (_lock)
        {
            _isGivenUp = true;
            if (_isBegun && File.Exists(TemporaryPath))
                File.Delete(TemporaryPath);
        }
    }

    // Without the extension of the file, so that *.csv is never half of a file.
    private string TemporaryPath => $"{_target}.{Environment.ProcessId}.part";

    private void Check()
    {
        if (InputFile.FindOddKind(path) is { } kind)
            throw new IOException($"'{path}' is {kind}; only regular files are written.");
        if (!overwrite && File.Exists(path))
            throw new IOException($"'{path}' already exists. --overwrite replaces it.");
    }

    private void Begin()
    {
        if (_isGivenUp)
            throw new OperationCanceledException();

        _target = (new FileInfo(path) is { LinkTarget: not null } link ? link.ResolveLinkTarget(returnFinalTarget: true)?.FullName : null) ?? path;
        _mode = !OperatingSystem.IsWindows() && File.Exists(_target) ? File.GetUnixFileMode(_target) : null;
        _isBegun = true;
    }

    private void Keep()
    {
        lock (_lock)
        {
            if (_isGivenUp)
                throw new OperationCanceledException();

            // Some file systems refuse to set permissions, and then all files have the same.
            if (!OperatingSystem.IsWindows() && _mode is { } mode && File.GetUnixFileMode(TemporaryPath) != mode)
                File.SetUnixFileMode(TemporaryPath, mode);

            File.Move(TemporaryPath, _target!, overwrite);
            _isBegun = false;
        }
    }
}
