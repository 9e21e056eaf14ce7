using System.Runtime.CompilerServices;

namespace NeuronMocap.Compatibility;

// Guards the functions that programs call. An exception inside becomes the function's failure value and a sentence in the last error. In C an
// exception would end the process.
internal static class FunctionGuard
{
    public static TResult Call<TArguments, TResult>(
        TArguments arguments, Func<TArguments, TResult> function, TResult failure, [CallerMemberName] string name = "")
    {
        try
        {
            return function(arguments);
        }
        catch (Exception exception) when (exception is not ThreadInterruptedException)
        {
            // The program itself interrupts a thread, and it expects this exception.
            Report(name, exception);
            return failure;
        }
    }

    // If memory runs out, there may not even be a last error.
    public static void Report(string name, Exception exception)
    {
        try
        {
            LastError.SetFault(name, exception);
        }
        catch (Exception)
        {
            // Only the failure value of the function reports it.
        }
    }
}
