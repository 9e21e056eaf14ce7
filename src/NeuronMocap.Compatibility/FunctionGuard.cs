using System.Runtime.CompilerServices;

namespace NeuronMocap.Compatibility;

// Stands around the functions that programs call: whatever is thrown inside becomes the function's failure, with a sentence as the last error. In C an
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
            // A thread is interrupted by the program itself, which waits for that.
            Report(name, exception);
            return failure;
        }
    }

    // Without memory there may not even be a last error.
    public static void Report(string name, Exception exception)
    {
        try
        {
            LastError.SetFault(name, exception);
        }
        catch (Exception)
        {
            // The function's failure has to tell it.
        }
    }
}
