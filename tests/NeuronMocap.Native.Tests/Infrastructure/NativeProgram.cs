using System.Diagnostics;
using System.Threading.Channels;

namespace NeuronMocap.Native.Tests.Infrastructure;

/// <summary>A program of tests/native that runs: lines in, lines out. It is killed when it is not ended.</summary>
internal sealed class NativeProgram : IAsyncDisposable
{
    private readonly Process _process;
    private readonly Channel<string> _lines = Channel.CreateUnbounded<string>();
    private readonly List<string> _errors = [];

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

    /// <summary>Starts a program of any language, whose input and outputs are this object's.</summary>
    public static NativeProgram Start(ProcessStartInfo start)
    {
        start.RedirectStandardInput = true;
        start.RedirectStandardOutput = true;
        start.RedirectStandardError = true;
        start.UseShellExecute = false;
        return new NativeProgram(start);
    }

    /// <summary>A program of tests/native, to be started in an environment that is to be changed first.</summary>
    public static ProcessStartInfo Prepare(string name, params string[] arguments)
    {
        string path = Path.Combine(AppContext.BaseDirectory, "native", name);
        Assert.SkipUnless(File.Exists(path), "The C programs are not built: a C compiler and CMake are needed, on Linux.");
        return new ProcessStartInfo(path, arguments);
    }

    public void Write(string line) => _process.StandardInput.WriteLine(line);

    /// <summary>The next line of its output.</summary>
    public async Task<string> ReadAsync()
    {
        Assert.True(await _lines.Reader.WaitToReadAsync(TestContext.Current.CancellationToken).Soon(), $"The program has ended. {Errors}");
        return await _lines.Reader.ReadAsync(TestContext.Current.CancellationToken);
    }

    /// <summary>The next line that begins so; those before it are passed over.</summary>
    public async Task<string> ReadAsync(string start)
    {
        while (true)
        {
            string line = await ReadAsync();
            if (line.StartsWith(start, StringComparison.Ordinal))
                return line;
        }
    }

    /// <summary>Writes a call, and gives what it returned.</summary>
    public async Task<string> CallAsync(string line)
    {
        Write(line);
        return (await ReadAsync("= "))[2..];
    }

    /// <summary>All lines that are left, once it has ended.</summary>
    public IEnumerable<string> ReadRest()
    {
        while (_lines.Reader.TryRead(out string? line))
            yield return line;
    }

    /// <summary>Ends its input; the number it ended with, 128 and more for a signal.</summary>
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

    private void Keep(string? line)
    {
        if (line is null)
            _lines.Writer.Complete();
        else
            _lines.Writer.TryWrite(line);
    }
}
