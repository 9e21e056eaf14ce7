using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;

namespace NeuronMocap.Native.Host;

// Stands around everything that C calls: an exception that left it would end the process. What is thrown becomes the function's failure and the last
// error. Arguments are handed in, so that no call needs memory.
internal static unsafe class ExportGuard
{
    // Tests throw it at a function, on their own thread.
    [ThreadStatic]
    private static Exception? _fault;

    public static Exception? Fault
    {
        get => _fault;
        set => _fault = value;
    }

    // What there is to say where not even a last error can be made. A constant: its memory stays where it is.
    public static IntPtr NoMemory => (IntPtr)Unsafe.AsPointer(ref MemoryMarshal.GetReference("Out of memory.\0"u8));

    public static TResult Call<TArguments, TResult>(
        TArguments arguments, Func<TArguments, TResult> function, TResult failure, [CallerMemberName] string name = "")
    {
        try
        {
            ThrowFault();
            return function(arguments);
        }
        catch (Exception exception)
        {
            FunctionGuard.Report(name, exception);
            return failure;
        }
    }

    public static void Run<TArguments>(TArguments arguments, Action<TArguments> function, [CallerMemberName] string name = "")
    {
        try
        {
            ThrowFault();
            function(arguments);
        }
        catch (Exception exception)
        {
            FunctionGuard.Report(name, exception);
        }
    }

    private static void ThrowFault()
    {
        if (_fault is not { } fault)
            return;

        _fault = null;
        throw fault;
    }
}
