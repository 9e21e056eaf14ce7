using System.Diagnostics;
using System.Threading.Channels;

namespace NeuronMocap.Native.Tests.Infrastructure;

/// <summary>A running program of tests/native that reads and writes lines. It is killed if it does not end.</summary>
internal sealed class NativeProgram : IAsyncDisposable
{
    private readonly Process _process;
    private readonly Channel<string> _lines = Channel.CreateUnbounded<string>();
    private readonly List<string> _errors = [];

    // Lines before the results of calls.
    private readonly Queue<string> _earlier = [];

    private NativeProgram(ProcessStartInfo start)
    {
        _process = new Process { StartInfo = start };
        _process.OutputDataReceived += (_, line) => Keep(line.Data);
        _process.ErrorDataReceived += (_, line) =>
        {
            if (line.Data is not null)
                lock (_errors)
                    _errors.Add(line.Data);
        };
        _process.Start();
        _process.BeginOutputReadLine();
        _process.BeginErrorReadLine();
    }

    public int Id => _process.Id;

    public string Errors
    {
        get
        {
            lock (_errors)
                return string.Join('\n', _errors);
        }
    }

    public static NativeProgram Start(string name, params string[] arguments) => Start(Prepare(name, arguments));

    /// <summary>Starts a program of any language, and connects its input and outputs to this object.</summary>
    public static NativeProgram Start(ProcessStartInfo start)
    {
        start.RedirectStandardInput = true;
        start.RedirectStandardOutput = true;
        start.RedirectStandardError = true;
        start.UseShellExecute = false;
        return new NativeProgram(start);
    }

    /// <summary>Prepares a program of tests/native, so that its environment can be changed before the start.</summary>
    public static ProcessStartInfo Prepare(string name, params string[] arguments)
    {
        string path = Path.Combine(AppContext.BaseDirectory, "native", name);
        Assert.SkipUnless(File.Exists(path), "The C programs are not built: a C compiler and CMake are needed, on Linux.");
        return new ProcessStartInfo(path, arguments);
    }

    public void Write(string line) => _process.StandardInput.WriteLine(line);

    /// <summary>Reads the next line of its output.</summary>
    public Task<string> ReadAsync() => _earlier.TryDequeue(out string? line) ? Task.FromResult(line) : ReadNextAsync();

    /// <summary>Reads up to the next line with this start, and skips the lines before it.</summary>
    public async Task<string> ReadAsync(string start)
    {
        while (true)
        {
            string line = await ReadAsync();
            if (line.StartsWith(start, StringComparison.Ordinal))
                return line;
        }
    }

    /// <summary>Writes a call and returns its result. Lines before it are read afterwards: a callback may come before the call returns.</summary>
    public async Task<string> CallAsync(string line)
    {
        Write(line);
        while (true)
        {
            string read = await ReadNextAsync();
            if (read.StartsWith("= ", StringComparison.Ordinal))
                return read[2..];

            _earlier.Enqueue(read);
        }
    }

    /// <summary>Returns all remaining lines after it has ended.</summary>
    public IEnumerable<string> ReadRest()
    {
        while (_earlier.TryDequeue(out string? line) || _lines.Reader.TryRead(out line))
            yield return line;
    }

    /// <summary>Ends its input, and returns the exit code: 128 or more for a signal.</summary>
    public async Task<int> EndAsync()
    {
        _process.StandardInput.Close();
        await _process.WaitForExitAsync(TestContext.Current.CancellationToken).Soon();
        return _process.ExitCode;
    }

    public async ValueTask DisposeAsync()
    {
        if (!_process.HasExited)
            _process.Kill();

        await _process.WaitForExitAsync(CancellationToken.None).WaitAsync(Limits.Unexpected, CancellationToken.None);
        _process.Dispose();
    }

    private async Task<string> ReadNextAsync()
    {
        Assert.True(await _lines.Reader.WaitToReadAsync(TestContext.Current.CancellationToken).Soon(), $"The program has ended. {Errors}");
        return await _lines.Reader.ReadAsync(TestContext.Current.CancellationToken);
    }

    private void Keep(string? line)
    {
        if (line is null)
            _lines.Writer.Complete();
        else
            _lines.Writer.TryWrite(line);
    }
}
