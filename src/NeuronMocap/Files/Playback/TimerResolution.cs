using System.Runtime.InteropServices;

namespace NeuronMocap.Recording;

// Windows wakes threads every 15.6 ms unless a program requests a higher resolution. Other systems always wake threads within a millisecond.
internal readonly struct TimerResolution : IDisposable
{
    private const uint Milliseconds = 1;

    private readonly bool _isRaised;

    private TimerResolution(bool isRaised) => _isRaised = isRaised;

    public static TimerResolution Raise() =>
        new(Environment.OSVersion.Platform == PlatformID.Win32NT && timeBeginPeriod(Milliseconds) == 0);

    public void Dispose()
    {
        if (_isRaised)
            _ = timeEndPeriod(Milliseconds);
    }

    [DllImport("winmm.dll")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.System32)]
    private static extern uint timeBeginPeriod(uint period);

    [DllImport("winmm.dll")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.System32)]
    private static extern uint timeEndPeriod(uint period);
}
