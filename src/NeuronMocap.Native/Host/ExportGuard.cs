using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;

namespace NeuronMocap.Native.Host;

// Guards all functions that C calls, because an exception that left them would end the process. An exception becomes the function's failure value and
// the last error. Arguments are passed in, so that a call allocates no memory.
internal static unsafe class ExportGuard
{
    // Tests set it to throw in a function, on their own thread.
    [ThreadStatic]
    private static Exception? _fault;

    public static Exception? Fault
    {
        get => _fault;
        set => _fault = value;
    }

    // The message when not even a last error can be created. It is a constant, so its memory does not move.
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
