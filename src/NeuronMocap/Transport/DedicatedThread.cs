namespace NeuronMocap.Transport;

internal static class DedicatedThread
{
    // Runs what blocks on a background thread of its own, which never keeps the process alive; the task ends as it does.
    public static Task RunAsync(string name, Action action)
    {
        var completion = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        new Thread(Run) { IsBackground = true, Name = name }.Start();
        return completion.Task;

        void Run()
        {
            try
            {
                action();
                completion.SetResult(true);
            }
            catch (Exception exception)
            {
                completion.SetException(exception);
            }
        }
    }
}
